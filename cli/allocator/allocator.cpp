#include <jemalloc/jemalloc.h>

/// What jemalloc reads when a program begins, which environment variable MALLOC_CONF may override:
/// huge pages behind all memory. Where the system is a guest of another, a page costs microseconds
/// when it is first touched, and that was up to half of a run.
const char* malloc_conf = "thp:always";
