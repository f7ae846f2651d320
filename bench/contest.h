#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include <tbb/global_control.h>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/stage_clock.h"
#include "process_usage.h"
#include "support/pipe_cases.h"
#include "union_cases.h"

/// One engine unites the pipes of one case, again and again, in a process of its own: rivals.py
/// starts one per engine and case, so that neither a crash nor a case without end stops the table.
/// Prints a line per step as soon as it is done, for whoever loses patience:
///   make|op|round SECONDS PROCESSOR-SECONDS
///   stage NAME SECONDS PROCESSOR-SECONDS
///   result TRIANGLES-BEFORE TRIANGLES-AFTER VOLUME OPERANDS PEAK-BYTES
///   invalid WHY
namespace dupin::bench {

/// What an engine's result is, apart from the time it took.
struct ContestResult {
  std::size_t triangles = 0;
  double volume = 0;
  std::string fault;              ///< why it is none; empty if it is one
  std::vector<StageTime> stages;  ///< of the operation, if the engine tells
};

struct ContestOptions {
  std::string name;
  int repetitions = 5;
  double budget = 10;       ///< seconds after which no repetition begins
  std::size_t threads = 2;  ///< TBB's
};

inline void print_step(const char* step, const Seconds& took) {
  std::printf("%s %.6f %.6f\n", step, took.wall, took.processor);
  std::fflush(stdout);
}

/// Steps are functions of Engine: `prepare` (not timed) puts the meshes into the engine's own
/// arrays, `make` makes solids of them, `unite` unites all, `round` makes a mesh of the result;
/// `describe` (not timed) looks at that and at the result.
template <class Engine>
void repeat_contest(const ContestOptions& options) {
  const double memory_before = process_memory("VmRSS:");
  const std::vector<TriMesh> meshes = test::pipe_case(options.name);
  std::size_t before = 0;
  for (const TriMesh& mesh : meshes) {
    before += mesh.triangles.size();
  }
  const auto prepared = Engine::prepare(meshes);
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, options.threads);
  const Seconds begin = now();
  for (int i = 0; i < options.repetitions && since(begin).wall < options.budget; ++i) {
    reset_peak();
    Engine engine;
    const auto step = [](const char* name, const auto& function) {
      const Seconds start = now();
      function();
      print_step(name, since(start));
    };
    step("make", [&] { engine.make(prepared); });
    step("op", [&] { engine.unite(); });
    step("round", [&] { engine.round(); });
    const double peak = process_memory("VmHWM:") - memory_before;
    const ContestResult result = engine.describe();
    for (const StageTime& stage : result.stages) {
      print_step(("stage " + stage.stage).c_str(), {stage.wall, stage.processor});
    }
    std::printf("result %zu %zu %.15g %zu %.0f\n", before, result.triangles, result.volume,
                meshes.size(), peak);
    if (!result.fault.empty() || !has_known_volume(options.name, result.volume, 1e-9)) {
      std::printf("invalid %s\n", result.fault.empty() ? "volume" : result.fault.c_str());
    }
    std::fflush(stdout);
  }
}

/// Arguments: CASE [REPETITIONS [BUDGET [THREADS]]].
template <class Engine>
int contest_main(int count, char** arguments) {
  if (count < 2) {
    std::fputs("usage: CASE [REPETITIONS [BUDGET-SECONDS [THREADS]]]\n", stderr);
    return 2;
  }
  ContestOptions options{arguments[1]};
  options.repetitions = count > 2 ? std::atoi(arguments[2]) : options.repetitions;
  options.budget = count > 3 ? std::atof(arguments[3]) : options.budget;
  options.threads = count > 4 ? std::strtoul(arguments[4], nullptr, 10) : options.threads;
  repeat_contest<Engine>(options);
  return EXIT_SUCCESS;
}

}  // namespace dupin::bench
