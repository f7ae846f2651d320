#pragma once

#include <array>
#include <span>

#include "dupin/kernel/mesh.h"
#include "predicates/sign_filter.h"

namespace dupin::predicates {

/// How two triangles meet beyond the corners they share.
enum class TriangleOverlap {
  none,
  crossing,  ///< in points or segments
  overlap,   ///< in an area: they are coplanar
};

/// Whether the three points are collinear, exactly.
[[nodiscard]] bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

/// The sign of (b - a) x (p - a) seen along `axis`, exactly.
[[nodiscard]] int exact_side_of_line(const Vec3& a, const Vec3& b, const Vec3& p, int axis);

/// One triangle to be tested against others, exactly. Corners are the same when their indices are;
/// points with different indices in the two triangles have different coordinates. Neither triangle
/// is degenerate.
class TriangleOverlapTest {
 public:
  TriangleOverlapTest(std::span<const Vec3> points, const Triangle& corners);

  /// Of a triangle that may be degenerate: whether it is, exactly.
  [[nodiscard]] bool is_degenerate() const;
  /// On which side of the triangle's plane a point certainly lies, else 0.
  [[nodiscard]] int certain_side(const Vec3& point) const { return plane_.side(point); }
  /// Whether a line seen along an axis, or a plane, certainly has the triangle on one side and
  /// another one, which may be degenerate, on the other.
  [[nodiscard]] bool certainly_apart_from(const std::array<Vec3, 3>& other) const;
  [[nodiscard]] TriangleOverlap meeting(const Triangle& other) const;

 private:
  [[nodiscard]] TriangleOverlap sharing_none(const Triangle& other) const;
  [[nodiscard]] TriangleOverlap sharing_one(int mine, const Triangle& other, int others) const;
  [[nodiscard]] TriangleOverlap sharing_two(int mine, const Triangle& other, int others) const;

  std::span<const Vec3> points_;
  Triangle corners_;
  PlaneFilter plane_;
  EdgeFilter edges_;  // seen along the plane's main axis
  Vec3 longest_;      // of the edges
};

}  // namespace dupin::predicates
