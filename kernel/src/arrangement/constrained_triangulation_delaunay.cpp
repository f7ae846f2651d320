#include <cmath>

#include "arrangement/constrained_triangulation.h"
#include "arrangement/implicit_predicates.h"

namespace dupin::arrangement {
namespace {

using Planar = std::array<double, 2>;

constexpr std::size_t next(std::size_t i) { return i == 2 ? 0 : i + 1; }
constexpr std::size_t previous(std::size_t i) { return i == 0 ? 2 : i - 1; }

// True only if d lies inside the circle through a, b, c beyond doubt. The bound is stage A of
// Shewchuk's incircle test, (10 + 96 u) u times the permanent, u = 2^-52 as rounding is upward; the
// addend covers underflow.
bool certainly_in_circle(const Planar& a, const Planar& b, const Planar& c, const Planar& d) {
  const double ax = a[0] - d[0], ay = a[1] - d[1], bx = b[0] - d[0], by = b[1] - d[1],
               cx = c[0] - d[0], cy = c[1] - d[1];
  const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  const double value =
      aa * (bx * cy - by * cx) + bb * (cx * ay - cy * ax) + cc * (ax * by - ay * bx);
  const double permanent = aa * (std::abs(bx * cy) + std::abs(by * cx)) +
                           bb * (std::abs(cx * ay) + std::abs(cy * ax)) +
                           cc * (std::abs(ax * by) + std::abs(ay * bx));
  return value > 12 * 0x1p-52 * permanent + 0x1p-900;
}

}  // namespace

void ConstrainedTriangulation::flip(std::uint32_t face, int corner) {
  const auto i = static_cast<std::size_t>(corner);
  const Face f = faces_[face];
  const std::uint32_t other = f.neighbours[i];
  const Face g = faces_[other];
  const auto j = static_cast<std::size_t>(corner_facing(other, face));
  const Vertex a = f.corners[i], b = f.corners[next(i)], c = g.corners[j],
               d = f.corners[previous(i)];
  set_face(face, a, b, c);
  set_face(other, a, c, d);
  // g's corners are c, d, b in order.
  connect(face, 2, f.neighbours[previous(i)], f.slots[previous(i)]);
  connect(face, 0, g.neighbours[next(j)], g.slots[next(j)]);
  connect(other, 0, g.neighbours[previous(j)], g.slots[previous(j)]);
  connect(other, 1, f.neighbours[next(i)], f.slots[next(i)]);
  connect(face, 1, other, kNone);
}

// Each flip lowers the paraboloid lifted over the rounded points, so the loop ends.
void ConstrainedTriangulation::improve(const Triangle& support) {
  const Vec3 origin = points_.approximation(support[0]);
  const Vec3 first = (points_.approximation(support[1]) - origin).normalized();
  const Vec3 normal = first.cross(points_.approximation(support[2]) - origin).normalized();
  const Vec3 second = normal.cross(first);
  planar_.clear();
  for (const VertexData& v : vertices_) {
    Vec3 p = origin;
    if (v.id < kNewPoint) {
      p = points_.approximation(v.id);
    } else if (v.id < kNewPoint + new_points_.size()) {
      const IntervalPoint& box = new_points_[v.id - kNewPoint].box;
      p = {box[0].sup(), box[1].sup(), box[2].sup()};
    }
    planar_.push_back({(p - origin).dot(first), (p - origin).dot(second)});
  }
  const auto push = [&](std::uint32_t face) {
    for (int i = 0; i < 3; ++i) {
      edges_.emplace_back(face, i);
    }
  };
  for (std::uint32_t face = 0; face < faces_.size(); ++face) {
    push(face);
  }
  while (!edges_.empty()) {
    const auto [face, corner] = edges_.back();
    edges_.pop_back();
    const auto i = static_cast<std::size_t>(corner);
    const Face& f = faces_[face];
    const std::uint32_t other = f.neighbours[i];
    if (other == kNone || f.slots[i] != kNone) {
      continue;
    }
    const Vertex a = f.corners[i], b = f.corners[next(i)], d = f.corners[previous(i)];
    const Vertex c = faces_[other].corners[static_cast<std::size_t>(corner_facing(other, face))];
    const auto is_frame = [this](Vertex v) { return vertices_[v].id >= kFirstFrameCorner; };
    if (is_frame(a) || is_frame(b) || is_frame(c) || is_frame(d) ||
        !certainly_in_circle(planar_[a], planar_[b], planar_[d], planar_[c]) ||
        turn(a, b, c) <= 0 || turn(a, c, d) <= 0) {
      continue;
    }
    flip(face, corner);
    push(face);
    push(other);
  }
}

}  // namespace dupin::arrangement
