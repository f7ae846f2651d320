// How fast is a mesh checked and established as a solid?
#include <cmath>
#include <numbers>

#include "dupin/kernel/check.h"
#include "dupin/kernel/solid.h"
#include "measured.h"
#include "pipes.h"

namespace {

using namespace dupin;

TriMesh pipe_of(std::int64_t triangles) {
  const auto segments = static_cast<std::uint32_t>(std::sqrt(triangles / 2));
  return bench::pipe(1, 0, 10, segments, segments);
}

// The inscribed prism.
double volume_of_pipe(const TriMesh& mesh) {
  const double segments = std::sqrt(mesh.triangles.size() / 2);
  return 10 * std::floor(segments) / 2 * std::sin(2 * std::numbers::pi / std::floor(segments));
}

void check_pipe(benchmark::State& state) {
  const TriMesh mesh = pipe_of(state.range(0));
  const Report report = check(mesh);
  bench::require(report.is_solid() && report.components == 1 && report.genus == 0, "topology");
  bench::require(std::abs(report.volume / volume_of_pipe(mesh) - 1) < 1e-4, "volume");
  for ([[maybe_unused]] const auto iteration : state) {
    benchmark::DoNotOptimize(check(mesh));
  }
  bench::report(state, mesh.triangles.size());
}

void establish_pipe(benchmark::State& state) {
  const TriMesh mesh = pipe_of(state.range(0));
  bench::require(Solid::from(mesh).triangle_count() == mesh.triangles.size(), "triangles");
  for ([[maybe_unused]] const auto iteration : state) {
    benchmark::DoNotOptimize(Solid::from(mesh));
  }
  bench::report(state, mesh.triangles.size());
}

void exact_volume(benchmark::State& state) {
  const Solid solid = Solid::from(pipe_of(state.range(0)));
  for ([[maybe_unused]] const auto iteration : state) {
    benchmark::DoNotOptimize(solid.exact_volume());
  }
  bench::report(state, solid.triangle_count());
}

BENCHMARK(check_pipe)->Unit(benchmark::kMillisecond)->RangeMultiplier(10)->Range(1000, 1000000);
BENCHMARK(establish_pipe)->Unit(benchmark::kMillisecond)->Arg(100000);
BENCHMARK(exact_volume)->Unit(benchmark::kMillisecond)->Arg(100000);

}  // namespace

BENCHMARK_MAIN();
