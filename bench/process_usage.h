#pragma once

#include <chrono>
#include <ctime>
#include <fstream>
#include <string>

#include <malloc.h>

namespace dupin::bench {

/// Seconds on the clock and of all threads' processors together.
struct Seconds {
  double wall = 0, processor = 0;
};

/// Since some moment; differences count.
inline Seconds now() {
  return {
      std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(),
      static_cast<double>(std::clock()) / CLOCKS_PER_SEC};
}

inline Seconds since(const Seconds& start) {
  const Seconds end = now();
  return {end.wall - start.wall, end.processor - start.processor};
}

/// Linux: a line of /proc/self/status in bytes, as the process's resident memory now ("VmRSS:") or
/// its peak since the last reset ("VmHWM:").
inline double process_memory(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == key) {
      double kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  }
  return 0;
}

/// What was freed goes back to the system first, lest it be taken again unseen.
inline void reset_peak() {
  ::malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

}  // namespace dupin::bench
