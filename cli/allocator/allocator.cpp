#include <jemalloc/jemalloc.h>

/// What jemalloc reads when a program begins, which environment variable MALLOC_CONF may override:
/// huge pages behind all memory. Where the system is a guest of another, a page costs microseconds
/// when it is first touched, and that was up to half of a run. What is freed goes back after half a
/// second, and large pieces of it serve small requests less: that takes 5 to 13 % off the peak of
/// unions, and no time.
const char* malloc_conf = "thp:always,dirty_decay_ms:500,lg_extent_max_active_fit:2";
