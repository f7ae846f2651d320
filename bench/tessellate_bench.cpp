// How long does the proof-carrying tessellation of Fig. 6 of [MS06] take, per tolerance? How many
// triangles does it need, and how many would rows at equal steps of t that keep the same bound?

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include <benchmark/benchmark.h>

#include "dupin/blends/tessellate.h"
#include "measured.h"

namespace dupin {
namespace {

RingedSurface figure_6() {
  const Vec3 to(10, 4, 0), arriving = Vec3(1, 2, 10) / std::sqrt(105.0);
  return {{Vec3::Zero(), -Vec3::UnitX(), 1},
          {to, arriving, 2},
          HermiteSpine{Vec3::Zero(), to, 10 * Vec3::UnitX(), 20 * arriving},
          CubicRadius{1, 2}};
}

// The mesh's area, from below, within what the bound leaves.
bool is_as_large_as(const RingedSurface& surface, const Tessellation& result, double tolerance) {
  double sum = 0;
  for (const auto& [a, b, c] : result.mesh.triangles) {
    const auto& p = result.mesh.points;
    const Vec3 u = p[b] - p[a], v = p[c] - p[a];
    sum += std::sqrt(u.squaredNorm() * v.squaredNorm() - u.dot(v) * u.dot(v)) / 2;
  }
  const double exact = area(surface);
  return sum < exact && exact - sum < tolerance * exact;
}

// The rows at equal steps that the bound of their worst one allows: with du^2 Muu / 8 spent around,
// as by segments_for, (dt^2 Mtt + 2 dt du Mtu + du^2 Muu) / 8 <= tolerance.
std::size_t uniform_triangles(const RingedSurface& surface, double tolerance) {
  const std::uint32_t segments = segments_for(surface, tolerance);
  const double du = 2 * std::acos(-1.0) / segments;
  SecondDerivativeBounds most;
  constexpr int kCells = 1024;
  for (int i = 0; i < kCells; ++i) {
    const auto here = second_derivative_bounds(surface, double(i) / kCells, (i + 1.0) / kCells);
    most.along = std::max(most.along, here.along);
    most.mixed = std::max(most.mixed, here.mixed);
    most.around = std::max(most.around, here.around);
  }
  const double left = 8 * tolerance - most.around * du * du;
  const double dt =
      (std::sqrt(du * du * most.mixed * most.mixed + most.along * left) - du * most.mixed) /
      most.along;
  return 2 * std::size_t(segments) * std::size_t(std::ceil(1 / dt));
}

void tessellate_bench(benchmark::State& state, double tolerance) {
  const RingedSurface blend = figure_6();
  Tessellation result;
  for ([[maybe_unused]] const auto iteration : state) {
    const RingSampling sampling{segments_for(blend, tolerance)};
    result = tessellate(blend, sampling, {tolerance});
    benchmark::DoNotOptimize(result);
  }
  bench::require(result.error_bound <= tolerance, "the error bound");
  bench::require(is_as_large_as(blend, result, tolerance), "the area of Fig. 6");
  const std::size_t uniform = uniform_triangles(blend, tolerance);
  bench::require(result.mesh.triangles.size() < uniform, "fewer triangles than equal steps");
  state.counters["uniform"] = double(uniform);
  state.counters["smallest_angle"] = smallest_angle(result.mesh);
  bench::report(state, result.mesh.triangles.size());
}

}  // namespace
}  // namespace dupin

int main(int argc, char** argv) {
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4}) {
    benchmark::RegisterBenchmark(("tessellate/fig6/" + std::to_string(tolerance)).c_str(),
                                 [=](auto& state) { dupin::tessellate_bench(state, tolerance); })
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
