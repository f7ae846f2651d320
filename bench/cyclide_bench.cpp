// How long does a chain of 10 000 spheres take, composed, meshed to 1e-3, and united?

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

#include <benchmark/benchmark.h>

#include "dupin/blends/build.h"
#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/tessellate.h"
#include "measured.h"

namespace dupin {
namespace {

constexpr std::size_t kSpheres = 10'001;  // an odd number: 5000 pieces
constexpr double kTolerance = 1e-3;

// A widening coil of 24 spheres per half turn, with a radius that swells and shrinks.
std::vector<PeVector> spheres() {
  std::vector<PeVector> result;
  for (std::size_t i = 0; i < kSpheres; ++i) {
    const double s = double(i), turn = s * std::numbers::pi / 24, reach = 1 + s / 10'000;
    result.push_back({{reach * std::cos(turn), reach * std::sin(turn), s / 150},
                      0.04 + 0.004 * std::sin(s / 3)});
  }
  return result;
}

CyclideChain composed(const std::vector<PeVector>& through) {
  return compose(through, initial_tangent(through[0], through[1], through[2]));
}

void compose_bench(benchmark::State& state) {
  const auto through = spheres();
  CyclideChain chain;
  for ([[maybe_unused]] const auto iteration : state) {
    chain = composed(through);
    benchmark::DoNotOptimize(chain);
  }
  bench::require(chain.pieces.size() == kSpheres / 2, "the number of pieces");
  bench::report(state, chain.pieces.size());
}

void tessellate_bench(benchmark::State& state) {
  const Chain tube = cyclide_tube(composed(spheres()));
  Tessellation result;
  for ([[maybe_unused]] const auto iteration : state) {
    result = tessellate(tube, {segments_for(tube, kTolerance)}, {kTolerance});
    benchmark::DoNotOptimize(result);
  }
  bench::require(result.error_bound <= kTolerance, "the error bound");
  bench::report(state, result.mesh.triangles.size());
}

// With a pipe across it, so that there is something to unite.
void unite_bench(benchmark::State& state) {
  Assembly assembly;
  assembly.tolerance = kTolerance;
  assembly.parts = {{"chain", CyclideChainThrough{ChainFree(), spheres(), {}, 0}},
                    {"pipe", PipeBetween{{-3, 0, 33}, {3, 0, 33}, 0.05}}};
  const double smooth = volume(cyclide_tube(composed(spheres())));
  Built built;
  for ([[maybe_unused]] const auto iteration : state) {
    built = build(assembly);
  }
  const double pipe = 6 * std::numbers::pi * 0.05 * 0.05;
  const double found = built.solid.volume();
  bench::require(found < smooth + pipe && found > smooth * (1 - 0.05), "the volume");
  bench::require(built.solid.components() == 1, "the number of components");
  bench::report(state, built.parts[0].triangles);
}

}  // namespace
}  // namespace dupin

int main(int argc, char** argv) {
  using benchmark::RegisterBenchmark;
  RegisterBenchmark("cyclide/compose/10001", dupin::compose_bench)->Unit(benchmark::kMillisecond);
  RegisterBenchmark("cyclide/tessellate/10001", dupin::tessellate_bench)
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1);
  RegisterBenchmark("cyclide/build/10001", dupin::unite_bench)
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
