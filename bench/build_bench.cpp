// How long does an example take from document to solid?

#include <cstdlib>
#include <filesystem>
#include <string>

#include <benchmark/benchmark.h>

#include "dupin/blends/build.h"
#include "dupin/io/assembly_json.h"
#include "measured.h"

namespace dupin {
namespace {

void build_bench(benchmark::State& state, const std::string& name, double tolerance) {
  const Assembly assembly =
      read_assembly(std::filesystem::path(DUPIN_SOURCE_DIR) / "examples" / name);
  Built built;
  for ([[maybe_unused]] const auto iteration : state) {
    built = build(assembly, {.tolerance = tolerance});
    benchmark::DoNotOptimize(built);
  }
  bench::require(built.solid.components() == 1 && built.solid.euler_number() == 2,
                 "one piece without handles");
  bench::report(state, built.solid.triangle_count());
}

}  // namespace
}  // namespace dupin

int main(int argc, char** argv) {
  struct Row {
    const char* name;
    double tolerance;
  };
  const Row rows[] = {{"reducer.json", 0.05},
                      {"reducer.json", 0.0005},
                      {"header.json", 0.01},
                      {"header.json", 0.0002},
                      {"plant-run.json", 0.2}};
  for (const auto& row : rows) {
    benchmark::RegisterBenchmark(
        ("build/" + std::string(row.name) + "/" + std::to_string(row.tolerance)).c_str(),
        [=](auto& state) { dupin::build_bench(state, row.name, row.tolerance); })
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
