#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "arrangement/input.h"
#include "arrangement/points/implicit_points.h"

/// Exact signs over points of a table. All need UpwardRounding in the calling thread; points with
/// the same id are the same point.
namespace dupin::arrangement {

/// The side of `p` as seen from the plane a b c: +1 where its normal (b - a) x (c - a) points.
[[nodiscard]] int side_of_plane(const PointTable& points, PointId a, PointId b, PointId c,
                                PointId p);

/// The same for one point after the other.
class PlaneSides {
 public:
  PlaneSides(const PointTable& points, PointId a, PointId b, PointId c);
  [[nodiscard]] int of(PointId p) const;
  /// The same if floating point tells, else 0; of an implicit point.
  [[nodiscard]] int of_enclosed(PointId p) const;

 private:
  [[nodiscard]] int filtered(const Vec3& p, const Vec3& reach) const;

  const PointTable& points_;
  std::array<PointId, 3> of_;
  bool is_of_doubles_;  // else there is nothing of the following
  Vec3 origin_, normal_;
  Vec3 size_;  // sums of the absolute products that the normal is made of
};

/// +1 if a, b, c turn left in the projection along `axis` (seen against the axis).
[[nodiscard]] int turn(const PointTable& points, PointId a, PointId b, PointId c, int axis);

/// The sign of the difference of the coordinates, a - b.
[[nodiscard]] int compare(const PointTable& points, PointId a, PointId b, int axis);

/// Whether the two points have the same coordinates.
[[nodiscard]] bool coincide(const PointTable& points, PointId a, PointId b);

/// A triangle that ends at an edge, as a half-plane around it.
struct HalfPlane {
  PointId apex;           ///< its corner off the edge
  std::uint32_t support;  ///< a triangle of the input with its plane and orientation
  bool forward;           ///< it runs along the edge from its lower to its upper end
  std::uint32_t owner;    ///< for the caller
};

/// Sorts half-planes around their common edge, counter-clockwise about its direction from the lower
/// to the upper end, beginning with the first. No two of them overlap.
void order_facets_around_edge(const ArrangementInput& input, std::vector<HalfPlane>& half_planes);

/// The sign of an interval, or 0 with `certain` unset when it contains more than one sign.
struct FilteredSign {
  int sign = 0;
  bool certain = false;
};
[[nodiscard]] inline FilteredSign sign_of(const Interval& x) {
  if (x.inf() > 0) return {1, true};
  if (x.sup() < 0) return {-1, true};
  return {0, x.inf() == 0 && x.sup() == 0};
}

[[nodiscard]] inline FilteredSign sign_of(const exact::Ball& x) {
  const int sign = x.sign();
  return {sign, sign != 0};
}

/// The turn of the projections, if balls tell.
[[nodiscard]] FilteredSign turn_of(const exact::BallPoint& a, const exact::BallPoint& b,
                                   const exact::BallPoint& c, int axis);
/// The sign of the determinant of exact points' projections: +1 if they turn left.
[[nodiscard]] int exact_turn(const mesh::ExactPoint& a, const mesh::ExactPoint& b,
                             const mesh::ExactPoint& c, int axis);
/// The sign of a - b in one coordinate.
[[nodiscard]] int exact_compare(const mesh::ExactPoint& a, const mesh::ExactPoint& b, int axis);

}  // namespace dupin::arrangement
