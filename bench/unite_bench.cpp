// How fast are pipes united, and does the time grow with what is cut or with what is there?
#include <vector>

#include "dupin/kernel/boolean.h"
#include "measured.h"
#include "pipes.h"

namespace {

using namespace dupin;

// By inclusion and exclusion, exactly.
void require_volume(const Solid& united, const std::vector<Solid>& operands,
                    const mpq_class& overlaps) {
  mpq_class expected = -overlaps;
  for (const Solid& operand : operands) {
    expected += operand.exact_volume();
  }
  bench::require(united.exact_volume() == expected, "volume");
  bench::require(united.components() == 1, "components");
}

// Two pipes that cross at right angles; the argument is the number of segments of each.
void tee(benchmark::State& state) {
  const auto segments = static_cast<std::uint32_t>(state.range(0));
  const std::vector<Solid> pipes = {
      Solid::from(bench::pipe(2, -10, 10, segments, 4)),
      Solid::from(bench::lying(bench::pipe(1, 0, 10, segments, 4), 0.3))};
  const Solid united = unite(pipes);
  require_volume(united, pipes, intersect(pipes).exact_volume());
  for ([[maybe_unused]] const auto iteration : state) {
    benchmark::DoNotOptimize(unite(pipes));
  }
  bench::report(state, pipes[0].triangle_count() + pipes[1].triangle_count());
}

// A main pipe with branches; the argument is the number of branches.
void header(benchmark::State& state) {
  std::vector<Solid> pipes = {
      Solid::from(bench::pipe(1, -1, static_cast<double>(state.range(0)) * 2, 32, 1))};
  mpq_class overlaps = 0;
  std::size_t triangles = pipes[0].triangle_count();
  for (int i = 0; i < state.range(0); ++i) {
    pipes.push_back(Solid::from(bench::lying(bench::pipe(0.5, 0.1, 3, 24, 1), 2.0 * i + 0.1)));
    const std::vector<Solid> pair = {pipes[0], pipes.back()};
    overlaps += intersect(pair).exact_volume();
    triangles += pipes.back().triangle_count();
  }
  require_volume(unite(pipes), pipes, overlaps);
  for ([[maybe_unused]] const auto iteration : state) {
    benchmark::DoNotOptimize(unite(pipes));
  }
  bench::report(state, triangles);
}

BENCHMARK(tee)->Unit(benchmark::kMillisecond)->Arg(32)->Arg(128);
BENCHMARK(header)->Unit(benchmark::kMillisecond)->Arg(10);

}  // namespace

BENCHMARK_MAIN();
