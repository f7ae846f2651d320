// How fast is a mesh of 10^6 triangles written to and read from memory, per format?

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <benchmark/benchmark.h>

#include "dupin/io/mesh_file.h"

namespace {

/// A torus of 1000 by 500 quadrilaterals with coordinates that need all their digits.
dupin::TriMesh torus() {
  constexpr std::uint32_t kAround = 1000;
  constexpr std::uint32_t kAcross = 500;
  dupin::TriMesh mesh;
  for (std::uint32_t i = 0; i < kAround; ++i) {
    for (std::uint32_t k = 0; k < kAcross; ++k) {
      const double u = 2 * 3.141592653589793 * i / kAround;
      const double v = 2 * 3.141592653589793 * k / kAcross;
      const double r = 10 + std::cos(v);
      mesh.points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
      const std::uint32_t a = i * kAcross + k;
      const std::uint32_t b = (i + 1) % kAround * kAcross + k;
      const std::uint32_t c = (i + 1) % kAround * kAcross + (k + 1) % kAcross;
      const std::uint32_t d = i * kAcross + (k + 1) % kAcross;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

void write_bench(benchmark::State& state, const dupin::MeshFormat& format) {
  const dupin::TriMesh mesh = torus();
  for ([[maybe_unused]] const auto iteration : state) {
    benchmark::DoNotOptimize(dupin::mesh_bytes(mesh, format));
  }
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}

void read_bench(benchmark::State& state, const dupin::MeshFormat& format) {
  const dupin::TriMesh mesh = torus();
  const std::string bytes = dupin::mesh_bytes(mesh, format);
  for ([[maybe_unused]] const auto iteration : state) {
    const dupin::TriMesh read_back = format.read(bytes, "torus");
    if (read_back.triangles.size() != mesh.triangles.size() ||
        read_back.points.size() != mesh.points.size()) {
      state.SkipWithError("the mesh read is not the mesh written");
    }
  }
  state.counters["bytes"] = static_cast<double>(bytes.size());
}

}  // namespace

int main(int argc, char** argv) {
  for (const dupin::MeshFormat& format : dupin::mesh_formats()) {
    const std::string format_name(format.name);
    benchmark::RegisterBenchmark(("write " + format_name).c_str(), write_bench, format)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("read " + format_name).c_str(), read_bench, format)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
