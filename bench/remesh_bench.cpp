// How long do meshes for solvers take, and how does that grow with the number of triangles: finer
// and finer ones of a tee, and more and more tees beside each other?

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/remesh.h"
#include "measured.h"
#include "pipes.h"

namespace dupin {
namespace {

constexpr double kDistance = 0.02;  // of pipes of radius 1

/// A pipe along z, and a thinner one that ends on its axis.
std::array<Solid, 2> tee(double at) {
  TriMesh run = bench::pipe(1, -4, 4, 48, 16), branch = bench::pipe(0.7, 0, 4, 36, 8);
  for (Vec3& p : branch.points) {
    p = Vec3(p.z(), p.x(), p.y());
  }
  for (TriMesh* mesh : {&run, &branch}) {
    for (Vec3& p : mesh->points) {
      p.y() += at;
    }
  }
  return {Solid::from(run), Solid::from(branch)};
}

Solid tees(int count) {
  std::vector<Solid> parts;
  for (int i = 0; i < count; ++i) {
    const auto [run, branch] = tee(4. * i);
    parts.insert(parts.end(), {run, branch});
  }
  return unite(parts);
}

RemeshOptions options_with(double edge) {
  RemeshOptions options;
  options.distance = kDistance;
  options.largest_edge = edge;
  return options;
}

void surface_bench(benchmark::State& state, int count, double edge) {
  const Solid solid = tees(count);
  const RemeshOptions options = options_with(edge);
  Remeshed result;
  for ([[maybe_unused]] const auto iteration : state) {
    result = remesh(solid, options);
  }
  const RemeshReport& report = result.report;
  bench::require(report.deviation <= kDistance, "the distance");
  bench::require(report.longest_edge <= edge, "the longest edge");
  bench::require(report.smallest_angle >= options.smallest_angle || report.poor_triangles > 0,
                 "the smallest angle");
  bench::require(std::abs(result.solid.volume() - solid.volume()) <= kDistance * solid.area(),
                 "the volume");
  state.counters["smallest_angle"] = report.smallest_angle * 180 / std::numbers::pi;
  state.counters["poor"] = static_cast<double>(report.poor_triangles);
  bench::report(state, result.solid.triangle_count());
}

}  // namespace
}  // namespace dupin

int main(int argc, char** argv) {
  if (!dupin::has_mesh_generator()) {
    return EXIT_SUCCESS;
  }
  const auto add = [](int count, double edge) {
    benchmark::RegisterBenchmark(
        ("remesh/tees:" + std::to_string(count) + "/edge:" + std::to_string(edge)).c_str(),
        [=](auto& state) { dupin::surface_bench(state, count, edge); })
        ->Unit(benchmark::kMillisecond);
  };
  for (const double edge : {0.4, 0.2, 0.1}) {
    add(1, edge);
  }
  for (const int count : {2, 4, 8}) {
    add(count, 0.4);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
