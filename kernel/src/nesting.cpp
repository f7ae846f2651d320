#include "nesting.h"

#include <algorithm>
#include <limits>

#include "orientation.h"

namespace dupin::detail {
namespace {

using CGAL::Mpzf;

struct Bounds {
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 upper = -lower;

  void join(const Vec3& point) {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
};

// Three times the centre of gravity of a triangle: a point that lies on no other shell, as shells
// touch in vertices and edges only. All is scaled by 3 to stay in integers.
struct TestPoint {
  ExactVector tripled;
  Bounds face;  // contains the point
};

ExactVector tripled(const Vec3& point) {
  return {Mpzf(point.x()) * 3, Mpzf(point.y()) * 3, Mpzf(point.z()) * 3};
}

Bounds bounds_of(const MeshView& mesh, std::uint32_t face) {
  Bounds bounds;
  for (const std::uint32_t corner : mesh.triangles[face]) {
    bounds.join(mesh.points[corner]);
  }
  return bounds;
}

// A small face makes few candidates for the ray.
TestPoint test_point(const MeshView& mesh, std::span<const std::uint32_t> faces) {
  const auto spread = [&](std::uint32_t face) {
    const Bounds bounds = bounds_of(mesh, face);
    return (bounds.upper - bounds.lower).tail<2>().sum();
  };
  const std::uint32_t face =
      *std::min_element(faces.begin(), faces.end(),
                        [&](std::uint32_t a, std::uint32_t b) { return spread(a) < spread(b); });
  ExactVector sum;
  for (const std::uint32_t corner : mesh.triangles[face]) {
    for (int i = 0; i < 3; ++i) {
      sum[i] = sum[i] + Mpzf(mesh.points[corner][i]);
    }
  }
  return {sum, bounds_of(mesh, face)};
}

// The ray runs from q along +x. So that it passes through no edge, q is thought moved by
// (0, e, e^2) for an infinitely small e > 0; y points right and z upwards in what follows.
bool is_above(const ExactVector& point, const ExactVector& q) { return point[2] > q[2]; }

// Whether q is left of the line from a upwards to b. A q on the line has moved to its right.
bool is_left_of(const ExactVector& q, const ExactVector& a, const ExactVector& b) {
  return sign((b[1] - a[1]) * (q[2] - a[2]) - (b[2] - a[2]) * (q[1] - a[1])) > 0;
}

bool is_hit(const ExactVector& q, const std::array<ExactVector, 3>& corners) {
  int crossed = 0;  // edges to the right of q
  for (std::size_t i = 0; i < 3; ++i) {
    const ExactVector &a = corners[i], &b = corners[(i + 1) % 3];
    if (is_above(a, q) != is_above(b, q)) {
      const bool upward = is_above(b, q);
      crossed += is_left_of(q, upward ? a : b, upward ? b : a) ? 1 : 0;
    }
  }
  if (crossed != 1) {
    return false;
  }
  const ExactVector normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  // q + t e_x is in the plane for t = -normal . (q - a) / normal_x.
  return sign(dot(normal, q - corners[0])) * sign(normal[0]) < 0;
}

bool contains(const MeshView& mesh, std::span<const std::uint32_t> shell, const TestPoint& point) {
  bool inside = false;
  for (const std::uint32_t face : shell) {
    const Bounds bounds = bounds_of(mesh, face);
    if (bounds.upper.x() < point.face.lower.x() || bounds.lower.y() > point.face.upper.y() ||
        bounds.upper.y() < point.face.lower.y() || bounds.lower.z() > point.face.upper.z() ||
        bounds.upper.z() < point.face.lower.z()) {
      continue;
    }
    const Triangle& t = mesh.triangles[face];
    const std::array<ExactVector, 3> corners = {
        tripled(mesh.points[t[0]]), tripled(mesh.points[t[1]]), tripled(mesh.points[t[2]])};
    inside ^= is_hit(point.tripled, corners);
  }
  return inside;
}

}  // namespace

std::vector<int> nesting_depths(const MeshView& mesh, const Shells& shells) {
  std::vector<int> depths(shells.count);
  if (shells.count < 2) {
    return depths;
  }
  std::vector<Bounds> boxes(shells.count);
  for (std::size_t shell = 0; shell < shells.count; ++shell) {
    for (const std::uint32_t face : shells.faces_of(shell)) {
      for (const std::uint32_t corner : mesh.triangles[face]) {
        boxes[shell].join(mesh.points[corner]);
      }
    }
  }
  for (std::size_t inner = 0; inner < shells.count; ++inner) {
    const TestPoint point = test_point(mesh, shells.faces_of(inner));
    for (std::size_t outer = 0; outer < shells.count; ++outer) {
      // A shell inside another has its box in the other's.
      const bool possible = outer != inner &&
                            (boxes[outer].lower.array() <= boxes[inner].lower.array()).all() &&
                            (boxes[outer].upper.array() >= boxes[inner].upper.array()).all();
      if (possible && contains(mesh, shells.faces_of(outer), point)) {
        ++depths[inner];
      }
    }
  }
  return depths;
}

}  // namespace dupin::detail
