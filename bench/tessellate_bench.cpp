// How long does the proof-carrying tessellation of Fig. 6 of [MS06] take, per tolerance?

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
