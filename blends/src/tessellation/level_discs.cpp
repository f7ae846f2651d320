#include "tessellation/level_discs.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/kernel/triangulate_region.h"
#include "numbers/point_order.h"

namespace dupin::tessellation {
namespace {

// Of a ring and its flipped one the same.
Ring canonical(const Ring& ring) {
  return numbers::PointOrder()(ring.normal, -ring.normal) ? flipped(ring) : ring;
}

// Corners of polygons are on their circles but for snapping, sides as far inside as this.
bool fits_into(const SampledRing& inner, const SampledRing& outer) {
  const double side = outer.ring.radius * std::cos(std::numbers::pi / outer.sampling.segments);
  return inner.ring.radius + 4 * (inner.sampling.grid + outer.sampling.grid) < side;
}

}  // namespace

std::vector<SampledRing> nested_rings(const SampledRing& disc,
                                      std::span<const SampledRing> within) {
  std::vector<SampledRing> rings{disc};
  for (auto ring = within.rbegin(); ring != within.rend(); ++ring) {
    if (fits_into(*ring, rings.back())) {
      rings.push_back(*ring);
      if (ring->ring.normal != disc.ring.normal) {
        rings.back().ring = flipped(ring->ring);
      }
    }
  }
  return rings;
}

void append_annulus(TriMesh& mesh, const SampledRing& inner, const SampledRing& outer) {
  const Ring ring = canonical(outer.ring);
  std::vector<Vec3> points = sample(canonical(inner.ring), inner.sampling);
  const std::vector<Vec3> around = sample(ring, outer.sampling);
  std::vector<std::vector<std::uint32_t>> polygons(2);
  polygons[0].resize(points.size());
  polygons[1].resize(around.size());
  std::iota(polygons[0].begin(), polygons[0].end(), 0U);
  std::iota(polygons[1].begin(), polygons[1].end(), std::uint32_t(points.size()));
  points.insert(points.end(), around.begin(), around.end());
  const Vec3 axis = reference_axis(ring), across = ring.normal.cross(axis);
  std::vector<Vec2> flat;
  flat.reserve(points.size());
  for (const Vec3& point : points) {
    flat.emplace_back((point - ring.center).dot(axis), (point - ring.center).dot(across));
  }
  const auto first = std::uint32_t(mesh.points.size());
  for (auto [a, b, c] : triangulate_region(flat, polygons)) {
    if (ring.normal != outer.ring.normal) {
      std::swap(b, c);
    }
    mesh.triangles.push_back({first + a, first + b, first + c});
  }
  mesh.points.insert(mesh.points.end(), points.begin(), points.end());
}

}  // namespace dupin::tessellation
