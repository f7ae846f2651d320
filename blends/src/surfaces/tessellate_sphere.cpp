#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "dupin/blends/tessellate.h"
#include "dupin/blends/tessellation.h"
#include "dupin/kernel/error.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin {
namespace {

std::uint32_t bands_for(std::uint32_t segments) { return segments / 2 + segments % 2; }

// The largest distance between a sphere and the quadrilaterals of its graticule. The corners of one
// lie on the sphere and in a plane; no point between them is further from the sphere than that
// plane's nearest point to the centre, and central projection pairs the points.
double graticule_error(double radius, std::uint32_t segments) {
  const std::uint32_t bands = bands_for(segments);
  const double half_step = std::cos(std::numbers::pi / segments);
  double nearest = 1;
  for (std::uint32_t i = 0; i < bands; ++i) {
    const double a = std::numbers::pi * i / bands, b = std::numbers::pi * (i + 1) / bands;
    const double xa = half_step * std::sin(a), xb = half_step * std::sin(b);
    const double za = std::cos(a), zb = std::cos(b);
    nearest = std::min(nearest, std::abs(xa * zb - xb * za) / std::hypot(xb - xa, zb - za));
  }
  return radius * (1 - nearest);
}

}  // namespace

std::uint32_t segments_for(const Sphere& sphere, double tolerance, double grid) {
  const double allowed =
      tessellation::allowed_error(tolerance, tessellation::point_error(sphere, grid));
  // Squares of side d on the equator are off by about R d^2 / 4.
  auto segments =
      tessellation::segment_count(std::numbers::pi * std::sqrt(sphere.radius / allowed));
  segments += segments % 2;
  while (graticule_error(sphere.radius, segments) > allowed) {
    segments += 2;
  }
  return segments;
}

Tessellation tessellate(const Sphere& sphere, const RingSampling& sampling) {
  validate(Ring{sphere.center, Vec3::UnitZ(), sphere.radius});
  const std::uint32_t n = sampling.segments, bands = bands_for(n);
  if (n < kFewestSegments) {
    throw Error(Errc::invalid_argument, "a sphere needs at least " +
                                            std::to_string(kFewestSegments) + " segments, not " +
                                            std::to_string(n));
  }
  tessellation::refuse_too_fine(2. * n * bands);
  Tessellation result{
      {},
      bands,
      graticule_error(sphere.radius, n) + tessellation::point_error(sphere, sampling.grid)};
  TriMesh& mesh = result.mesh;
  const auto pole = [&](double sign) {
    mesh.points.push_back(
        snapped(sphere.center + sign * sphere.radius * Vec3::UnitZ(), sampling.grid));
    return std::uint32_t(mesh.points.size() - 1);
  };
  const std::uint32_t south = pole(-1);
  for (std::uint32_t j = 1; j < bands; ++j) {
    const double latitude = std::numbers::pi * j / bands - std::numbers::pi / 2;
    const Ring parallel{sphere.center + sphere.radius * std::sin(latitude) * Vec3::UnitZ(),
                        Vec3::UnitZ(), sphere.radius * std::cos(latitude)};
    const auto points = sample(parallel, sampling);
    mesh.points.insert(mesh.points.end(), points.begin(), points.end());
  }
  const std::uint32_t north = pole(1);
  const auto at = [&](std::uint32_t row, std::uint32_t i) { return 1 + row * n + i % n; };
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.triangles.push_back({south, at(0, i + 1), at(0, i)});
    for (std::uint32_t row = 0; row + 2 < bands; ++row) {
      mesh.triangles.push_back({at(row, i), at(row, i + 1), at(row + 1, i + 1)});
      mesh.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row + 1, i)});
    }
    mesh.triangles.push_back({at(bands - 2, i), at(bands - 2, i + 1), north});
  }
  return result;
}

}  // namespace dupin
