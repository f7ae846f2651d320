#pragma once

#include <cstddef>
#include <cstdlib>
#include <iostream>

#include <benchmark/benchmark.h>
#include <sys/resource.h>

namespace dupin::bench {

/// Stops the program if a result is not the reference: a fast wrong answer is no measurement.
inline void require(bool holds, const char* what) {
  if (!holds) {
    std::cerr << "not as in the reference: " << what << '\n';
    std::exit(1);
  }
}

/// Adds size, throughput and the process's peak memory so far to the printed row.
inline void report(benchmark::State& state, std::size_t triangles) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["triangles/s"] = benchmark::Counter(static_cast<double>(triangles),
                                                     benchmark::Counter::kIsIterationInvariantRate);
  state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024;  // Linux: kilobytes
}

}  // namespace dupin::bench
