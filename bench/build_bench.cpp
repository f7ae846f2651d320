// How long does it take from document to solid: examples, runs with more and more fillets, larger
// and larger graphs, more and more piping lines?

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <benchmark/benchmark.h>

#include "dupin/blends/build.h"
#include "dupin/blends/drawing.h"
#include "dupin/blends/pipe_graph.h"
#include "dupin/blends/piping_line.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/atomic_file.h"
#include "dupin/io/pcf.h"
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

// A run with so many branches, each with a fillet; none of them meets another.
Assembly header(std::size_t branches) {
  constexpr double kApart = 20;
  Assembly assembly{"header", Unit::millimetre, 0.05, {}, {}};
  const double length = kApart * double(branches);
  assembly.parts.push_back({"run", PipeBetween{Vec3(-kApart, 0, 0), Vec3(length, 0, 0), 8}});
  for (std::size_t i = 0; i < branches; ++i) {
    const std::string number = std::to_string(i);
    const Vec3 at(kApart * double(i), 0, 0);
    assembly.parts.push_back({"b" + number, PipeBetween{at, at + Vec3(0, 0, 30), 4}});
    assembly.parts.push_back({"f" + number, FilletBetween{{"run", "b" + number}, 1.5}});
  }
  return assembly;
}

void fillets_bench(benchmark::State& state) {
  const Assembly assembly = header(std::size_t(state.range(0)));
  Built built;
  for ([[maybe_unused]] const auto iteration : state) {
    built = build(assembly);
    benchmark::DoNotOptimize(built);
  }
  bench::require(built.solid.components() == 1 && built.solid.euler_number() == 2,
                 "one piece without handles");
  bench::report(state, built.solid.triangle_count());
  state.SetComplexityN(state.range(0));
}

// A spine with a zigzag on each of its nodes: none of its edges passes another.
PipeGraph comb(std::size_t nodes) {
  PipeGraph graph;
  const auto teeth = std::size_t(std::sqrt(double(nodes)));
  for (std::size_t i = 0; i < teeth; ++i) {
    for (std::size_t k = 0; k < teeth; ++k) {
      const std::size_t node = graph.nodes.size();
      const double aside = k % 2 == 0 ? 0 : 4;
      graph.nodes.push_back(
          {std::to_string(node), Vec3(20 * double(i), 20 * double(k), aside), 1, 0});
      if (node > 0) {
        graph.edges.push_back({k == 0 ? node - teeth : node - 1, node, 0});
      }
    }
  }
  return graph;
}

void graph_bench(benchmark::State& state) {
  const PipeGraph graph = comb(std::size_t(state.range(0)));
  Built built;
  for ([[maybe_unused]] const auto iteration : state) {
    built = build(assembly_of(graph).assembly);
    benchmark::DoNotOptimize(built);
  }
  bench::require(built.solid.components() == 1 && built.solid.euler_number() == 2,
                 "one piece without handles");
  bench::report(state, built.solid.triangle_count());
  state.counters["nodes/s"] =
      benchmark::Counter(double(graph.nodes.size()), benchmark::Counter::kIsIterationInvariantRate);
  state.SetComplexityN(state.range(0));
}

// The example's line so many times side by side.
PipingLine lines(std::size_t count) {
  const std::filesystem::path file =
      std::filesystem::path(DUPIN_SOURCE_DIR) / "examples" / "line.pcf";
  const PipingLine one = parse_pcf(read_file(file), file.string()).line;
  PipingLine result{one.source, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 aside(5000 * double(i % 8), 0, 5000 * std::floor(double(i) / 8));
    for (PipingComponent component : one.components) {
      component.name += "-" + std::to_string(i);
      for (PipingPort& port : component.ports) {
        port.center += aside;
      }
      if (component.center) {
        *component.center += aside;
      }
      result.components.push_back(std::move(component));
    }
  }
  return result;
}

void piping_bench(benchmark::State& state) {
  const PipingLine line = lines(std::size_t(state.range(0)));
  Built built;
  for ([[maybe_unused]] const auto iteration : state) {
    built = build(assembly_of(line).assembly, {.tolerance = 0.1, .most_triangles = 20'000'000});
    benchmark::DoNotOptimize(built);
  }
  bench::require(built.solid.components() == std::size_t(state.range(0)), "a piece for each line");
  bench::report(state, built.solid.triangle_count());
  state.counters["components/s"] = benchmark::Counter(
      double(line.components.size()), benchmark::Counter::kIsIterationInvariantRate);
  state.SetComplexityN(state.range(0));
}

// Of the same lines, seen from aside: drawn, not built.
void drawing_bench(benchmark::State& state) {
  const Assembly assembly = assembly_of(lines(std::size_t(state.range(0)))).assembly;
  const Built built = build(assembly, {.tolerance = 0.1, .most_triangles = 20'000'000});
  Drawing drawing;
  for ([[maybe_unused]] const auto iteration : state) {
    drawing = draw(assembly, built, {view_along({-1, 1, -1}), true});
    benchmark::DoNotOptimize(drawing);
  }
  bench::require(!drawing.lines.empty(), "lines");
  bench::report(state, built.solid.triangle_count());
  state.SetComplexityN(state.range(0));
}

}  // namespace
}  // namespace dupin

int main(int argc, char** argv) {
  struct Row {
    const char* name;
    double tolerance;
  };
  const Row rows[] = {{"reducer.json", 0.05},  {"reducer.json", 0.0005}, {"header.json", 0.01},
                      {"header.json", 0.0002}, {"plant-run.json", 0.2},  {"tee.json", 0.02},
                      {"equal-tee.json", 0.02}};
  for (const auto& row : rows) {
    benchmark::RegisterBenchmark(
        ("build/" + std::string(row.name) + "/" + std::to_string(row.tolerance)).c_str(),
        [=](auto& state) { dupin::build_bench(state, row.name, row.tolerance); })
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::RegisterBenchmark("fillets", dupin::fillets_bench)
      ->RangeMultiplier(10)
      ->Range(10, 1000)
      ->Complexity()
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("graphs", dupin::graph_bench)
      ->RangeMultiplier(5)
      ->Range(100, 2500)
      ->Complexity()
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("piping", dupin::piping_bench)
      ->RangeMultiplier(4)
      ->Range(1, 64)
      ->Complexity()
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("drawing", dupin::drawing_bench)
      ->RangeMultiplier(4)
      ->Range(1, 64)
      ->Complexity()
      ->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
