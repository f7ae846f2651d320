#include "predicates/triangle_overlap.h"

#include <algorithm>
#include <array>
#include <optional>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "predicates/lattice_orientation.h"

namespace dupin::predicates {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corners = std::array<Vec3, 3>;
using Sides = std::array<int, 3>;

Kernel::Point_3 point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

int exact_side(const Corners& plane, const Vec3& p) {
  if (const auto sign = lattice_orientation(plane[0], plane[1], plane[2], p)) {
    return *sign;
  }
  return CGAL::orientation(point(plane[0]), point(plane[1]), point(plane[2]), point(p));
}

/// On which side of a plane, whose filter is given, a point lies, exactly.
int side_of(const PlaneFilter& filter, const Corners& plane, const Vec3& p) {
  const int certain = filter.side(p);
  return certain != 0 ? certain : exact_side(plane, p);
}

/// +1 or -1 if all three have that sign, else 0.
int common_sign(const Sides& sides) {
  return sides[0] == sides[1] && sides[1] == sides[2] ? sides[0] : 0;
}

int common_sign(int a, int b) { return a == b ? a : 0; }

/// An axis along which the triangle does not project to a segment.
int projection_axis(const Corners& t, int guess) {
  int axis = guess;
  while (exact_side_of_line(t[0], t[1], t[2], axis) == 0) {
    axis = (axis + 1) % 3;
  }
  return axis;
}

/// Whether some edge line of `t`, seen along `axis`, has t on one side and all `others` on the
/// opposite one, or, if `touching`, on the line; `side` is a predicate like side_of_line.
template <class Side>
bool edge_separates(const Corners& t, std::span<const Vec3> others, int axis, Side side,
                    bool touching = false) {
  const int inner = side(t[0], t[1], t[2], axis);
  for (int i = 0; inner != 0 && i < 3; ++i) {
    const auto beyond = [&](const Vec3& p) {
      const int turn = side(t[i], t[(i + 1) % 3], p, axis);
      return turn == -inner || (touching && turn == 0);
    };
    if (std::ranges::all_of(others, beyond)) {
      return true;
    }
  }
  return false;
}

TriangleOverlap coplanar_meeting(const Corners& a, const Corners& b, int axis) {
  if (edge_separates(a, b, axis, exact_side_of_line) ||
      edge_separates(b, a, axis, exact_side_of_line)) {
    return TriangleOverlap::none;
  }
  return edge_separates(a, b, axis, exact_side_of_line, true) ||
                 edge_separates(b, a, axis, exact_side_of_line, true)
             ? TriangleOverlap::crossing
             : TriangleOverlap::overlap;
}

/// Whether the closed segments pq and rs, coplanar, meet, seen along `axis`.
bool segments_meet(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, int axis) {
  const int pr = exact_side_of_line(p, q, r, axis), ps = exact_side_of_line(p, q, s, axis);
  const int rp = exact_side_of_line(r, s, p, axis), rq = exact_side_of_line(r, s, q, axis);
  if (pr != 0 || ps != 0) {
    return pr * ps <= 0 && rp * rq <= 0;
  }
  for (int k = 0; k < 3; ++k) {  // on one line: both ranges must meet along every axis
    if (std::max(p[k], q[k]) < std::min(r[k], s[k]) ||
        std::max(r[k], s[k]) < std::min(p[k], q[k])) {
      return false;
    }
  }
  return true;
}

/// Whether a point in the plane of `t` lies in t.
bool contains(const Corners& t, const Vec3& p, int axis) {
  const int inner = exact_side_of_line(t[0], t[1], t[2], axis);
  for (int i = 0; i < 3; ++i) {
    if (exact_side_of_line(t[i], t[(i + 1) % 3], p, axis) == -inner) {
      return false;
    }
  }
  return true;
}

/// Whether the segment pq, in the plane of `t`, meets t.
bool meets_in_plane(const Vec3& p, const Vec3& q, const Corners& t, int axis) {
  for (int i = 0; i < 3; ++i) {
    if (segments_meet(p, q, t[i], t[(i + 1) % 3], axis)) {
      return true;
    }
  }
  return contains(t, p, axis);
}

/// Whether the segment pq meets `t`, given the sides of its ends.
bool meets(const Vec3& p, const Vec3& q, int side_p, int side_q, const Corners& t, int axis) {
  if (side_p * side_q > 0) {
    return false;
  }
  if (side_p == 0 && side_q == 0) {
    return meets_in_plane(p, q, t, projection_axis(t, axis));
  }
  bool left = false, right = false;
  for (int i = 0; i < 3 && !(left && right); ++i) {
    const int turn = side_of(PlaneFilter(p, q, t[i]), {p, q, t[i]}, t[(i + 1) % 3]);
    left = left || turn > 0;
    right = right || turn < 0;
  }
  return !(left && right);
}

/// Position of a ray from v through p in the cone of the rays through a and b, all in one plane:
/// 1 inside, 0 on a boundary ray, -1 outside.
int place_in_cone(const Vec3& v, const Vec3& a, const Vec3& b, const Vec3& p, int axis) {
  const int turn = exact_side_of_line(v, a, b, axis);
  const int from_a = turn * exact_side_of_line(v, a, p, axis);
  const int to_b = turn * exact_side_of_line(v, p, b, axis);
  return std::min(from_a, to_b);
}

TriangleOverlap coplanar_cones(const Corners& a, const Corners& b, int axis) {
  const int in_a[] = {place_in_cone(a[0], a[1], a[2], b[1], axis),
                      place_in_cone(a[0], a[1], a[2], b[2], axis)};
  const int in_b[] = {place_in_cone(b[0], b[1], b[2], a[1], axis),
                      place_in_cone(b[0], b[1], b[2], a[2], axis)};
  if (in_a[0] > 0 || in_a[1] > 0 || in_b[0] > 0 || in_b[1] > 0 || (in_a[0] == 0 && in_a[1] == 0)) {
    return TriangleOverlap::overlap;
  }
  return in_a[0] == 0 || in_a[1] == 0 ? TriangleOverlap::crossing : TriangleOverlap::none;
}

/// Triangles that share their first corner.
TriangleOverlap cones_meeting(const Corners& a, const PlaneFilter& of_a, const Corners& b,
                              const PlaneFilter& of_b, int axis) {
  const int first = side_of(of_a, a, b[1]), second = side_of(of_a, a, b[2]);
  if (first * second > 0) {
    return TriangleOverlap::none;
  }
  if (first == 0 && second == 0) {
    return coplanar_cones(a, b, projection_axis(a, axis));
  }
  if (first == 0 || second == 0) {
    const Vec3& in_plane = first == 0 ? b[1] : b[2];
    return place_in_cone(a[0], a[1], a[2], in_plane, projection_axis(a, axis)) >= 0
               ? TriangleOverlap::crossing
               : TriangleOverlap::none;
  }
  // The edge b1 b2 pierces the plane of a where its turns with a0 a1 and a2 a0 say, which the sides
  // of b are: a0 is b0.
  const int past_first = first * side_of(of_b, b, a[1]);
  const int before_second = -first * side_of(of_b, b, a[2]);
  return past_first <= 0 && before_second <= 0 ? TriangleOverlap::crossing : TriangleOverlap::none;
}

/// Whether a line through the common first corner, seen along `axis`, certainly separates the
/// cones.
bool cones_certainly_apart(const Corners& a, const Corners& b, int axis) {
  for (int i = 1; i < 3; ++i) {
    const int inner = side_of_line(a[0], a[i], a[3 - i], axis);
    if (inner != 0 && side_of_line(a[0], a[i], b[1], axis) == -inner &&
        side_of_line(a[0], a[i], b[2], axis) == -inner) {
      return true;
    }
  }
  return false;
}

Vec3 longest_edge(const Corners& t) {
  const Vec3 first = t[1] - t[0], second = t[2] - t[1], third = t[0] - t[2];
  const double of_first = first.squaredNorm(), of_second = second.squaredNorm(),
               of_third = third.squaredNorm();
  return of_first >= of_second && of_first >= of_third ? first
         : of_second >= of_third                       ? second
                                                       : third;
}

/// Whether a plane along the longest edges of both certainly has one triangle on one side and the
/// other on the other: nearly always so where long triangles pass over each other. Whatever the
/// normal is, rounded as it may be, only the products with it have to be certain.
bool certainly_apart_across(const Corners& a, const Vec3& longest_of_a, const Corners& b) {
  const Vec3 normal = longest_of_a.cross(longest_edge(b)), size = normal.cwiseAbs();
  double sizes = 0;  // of all products; no number where one of them is none
  const auto along = [&](const Vec3& p) {
    const Vec3 from = p - a[0];
    sizes += size.dot(from.cwiseAbs());
    return normal.dot(from);
  };
  const double a1 = along(a[1]), a2 = along(a[2]);
  const auto [low_a, high_a] = std::minmax({0.0, a1, a2});
  const double b0 = along(b[0]), b1 = along(b[1]), b2 = along(b[2]);
  const auto [low_b, high_b] = std::minmax({b0, b1, b2});
  // Differences, products and two sums err by less than 5 ulps each, of either side.
  const double bound = 32 * kHalfUlp * sizes + 0x1p-900;
  return low_b - high_a > bound || low_a - high_b > bound;
}

/// Of the corners of t, those that are certain being given.
Sides exact_sides(const Sides& certain, const Corners& plane, const Corners& t) {
  const auto side = [&](int i) { return certain[i] != 0 ? certain[i] : exact_side(plane, t[i]); };
  return {side(0), side(1), side(2)};
}

/// The corner that the plane of another triangle, whose sides are given, cuts off alone; none if a
/// side is uncertain, or 0.
std::optional<int> lone_corner(const Sides& sides) {
  if (sides[0] == 0 || sides[1] == 0 || sides[2] == 0) {
    return std::nullopt;
  }
  return sides[1] == sides[2] ? 0 : sides[0] == sides[2] ? 1 : 2;
}

/// Whether the plane of another triangle, whose sides may be uncertain, may cut off corner i alone.
bool may_be_lone(const Sides& sides, int i) {
  const int a = sides[(i + 1) % 3], b = sides[(i + 2) % 3];
  return a * b >= 0 && sides[i] * a <= 0 && sides[i] * b <= 0;
}

/// For triangles that cross each other's planes, if certain: how they meet. Both cut a segment out
/// of the line that their planes have in common [Guigue and Devillers, Fast and Robust
/// Triangle-Triangle Overlap Test Using Orientation Predicates, 2003]; its ends lie on the edges at
/// the lone corners, and the four turns of an edge of one and an edge of the other say how the ends
/// follow each other: all alike if the segments are apart.
std::optional<TriangleOverlap> certain_meeting(const Corners& a, int lone_a, const Corners& b,
                                               int lone_b) {
  const Vec3 &p = a[lone_a], &q = b[lone_b];
  const Vec3 &q1 = b[(lone_b + 1) % 3], &q2 = b[(lone_b + 2) % 3];
  const PlaneFilter first(p, q, a[(lone_a + 1) % 3]), second(p, q, a[(lone_a + 2) % 3]);
  const Sides turns = {first.side(q1), first.side(q2), second.side(q1)};
  const int last = second.side(q2);
  if (turns[0] == 0 || turns[1] == 0 || turns[2] == 0 || last == 0) {
    return std::nullopt;
  }
  return common_sign(turns) == last ? TriangleOverlap::none : TriangleOverlap::crossing;
}

/// The same, exactly: segments that have an end in common have a turn of 0 there.
TriangleOverlap exact_meeting(const Corners& a, int lone_a, const Corners& b, int lone_b) {
  const Vec3 &p = a[lone_a], &q = b[lone_b];
  const std::array<Vec3, 2> ends = {b[(lone_b + 1) % 3], b[(lone_b + 2) % 3]};
  int common = 0;
  for (int i = 1; i < 3; ++i) {
    const Corners plane = {p, q, a[(lone_a + i) % 3]};
    const PlaneFilter filter(plane[0], plane[1], plane[2]);
    for (int k = 0; k < 2; ++k) {
      const int turn = side_of(filter, plane, ends[k]);
      if (turn == 0 || turn == -common) {
        return TriangleOverlap::crossing;
      }
      common = turn;
    }
  }
  return TriangleOverlap::none;
}

/// Whether triangles certainly do not meet, whatever sides that are uncertain are.
///
/// Lemma: let b not lie in the plane of a, nor a in that of b. A corner on the plane may count as
/// on either side: if a turn of two edges is not zero they do not meet, also where one ends in that
/// plane, so that what follows of the segments, which depend on the corners continuously, for
/// corners a little beside it follows for them.
bool certainly_apart(const Corners& a, const Sides& sides_a, const Corners& b,
                     const Sides& sides_b) {
  constexpr Sides kUnknown{0, 0, 0};
  if (sides_a == kUnknown || sides_b == kUnknown) {
    return false;
  }
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3 && may_be_lone(sides_a, i); ++k) {
      if (may_be_lone(sides_b, k) && certain_meeting(a, i, b, k) != TriangleOverlap::none) {
        return false;
      }
    }
  }
  return true;
}

/// Whether a triangle with corners on one side of the plane of `t` and in it, as its sides say,
/// meets t: the corner or the edge that it has in the plane does. None if it is on both sides.
std::optional<bool> touches(const Corners& other, const Sides& sides, const Corners& t, int axis) {
  if (*std::ranges::min_element(sides) * *std::ranges::max_element(sides) < 0) {
    return std::nullopt;
  }
  std::array<Vec3, 3> in_plane;
  std::size_t count = 0;
  for (int i = 0; i < 3; ++i) {
    if (sides[i] == 0) {
      in_plane[count++] = other[i];
    }
  }
  if (edge_separates(t, std::span(in_plane).first(count), axis, side_of_line)) {
    return false;
  }
  const int exact_axis = projection_axis(t, axis);
  return count == 1 ? contains(t, in_plane[0], exact_axis)
                    : meets_in_plane(in_plane[0], in_plane[1], t, exact_axis);
}

/// Whether an edge of a triangle, whose sides are given, meets `t`.
bool any_edge_meets(const Corners& edges, const Sides& sides, const Corners& t, int axis) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (meets(edges[i], edges[j], sides[i], sides[j], t, axis)) {
      return true;
    }
  }
  return false;
}

}  // namespace

int exact_side_of_line(const Vec3& a, const Vec3& b, const Vec3& p, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  return CGAL::orientation(Kernel::Point_2(a[i], a[j]), Kernel::Point_2(b[i], b[j]),
                           Kernel::Point_2(p[i], p[j]));
}

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  return !PlaneFilter(a, b, c).certain() && CGAL::collinear(point(a), point(b), point(c));
}

TriangleOverlapTest::TriangleOverlapTest(std::span<const Vec3> points, const Triangle& corners)
    : points_(points),
      corners_(corners),
      plane_(points[corners[0]], points[corners[1]], points[corners[2]]),
      edges_({points[corners[0]], points[corners[1]], points[corners[2]]}, plane_.main_axis()),
      longest_(longest_edge({points[corners[0]], points[corners[1]], points[corners[2]]})) {}

bool TriangleOverlapTest::certainly_apart_from(const std::array<Vec3, 3>& b) const {
  for (int k = 0; k < 3; ++k) {
    if (edges_.is_beyond(k, b[0]) && edges_.is_beyond(k, b[1]) && edges_.is_beyond(k, b[2])) {
      return true;
    }
  }
  return certainly_apart_across({points_[corners_[0]], points_[corners_[1]], points_[corners_[2]]},
                                longest_, b);
}

bool TriangleOverlapTest::is_degenerate() const {
  const auto& [a, b, c] = corners_;
  return !plane_.certain() && collinear(points_[a], points_[b], points_[c]);
}

TriangleOverlap TriangleOverlapTest::meeting(const Triangle& other) const {
  int shared = 0, mine = 0, others = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (corners_[i] == other[j]) {
        ++shared;
        mine += i;
        others += j;
      }
    }
  }
  switch (shared) {
    case 0:
      return sharing_none(other);
    case 1:
      return sharing_one(mine, other, others);
    case 2:  // the indices of the free corners
      return sharing_two(3 - mine, other, 3 - others);
    default:
      return TriangleOverlap::overlap;
  }
}

TriangleOverlap TriangleOverlapTest::sharing_two(int mine, const Triangle& other,
                                                 int others) const {
  const Vec3& far = points_[other[others]];
  if (plane_.side(far) != 0) {
    return TriangleOverlap::none;
  }
  const Corners t = {points_[corners_[(mine + 1) % 3]], points_[corners_[(mine + 2) % 3]],
                     points_[corners_[mine]]};
  const int axis = plane_.main_axis();
  if (side_of_line(t[0], t[1], t[2], axis) * side_of_line(t[0], t[1], far, axis) < 0 ||
      exact_side(t, far) != 0) {
    return TriangleOverlap::none;
  }
  const int exact_axis = projection_axis(t, axis);
  return exact_side_of_line(t[0], t[1], t[2], exact_axis) ==
                 exact_side_of_line(t[0], t[1], far, exact_axis)
             ? TriangleOverlap::overlap
             : TriangleOverlap::none;
}

TriangleOverlap TriangleOverlapTest::sharing_one(int mine, const Triangle& other,
                                                 int others) const {
  const Vec3 &b1 = points_[other[(others + 1) % 3]], &b2 = points_[other[(others + 2) % 3]];
  if (common_sign(plane_.side(b1), plane_.side(b2)) != 0) {
    return TriangleOverlap::none;
  }
  for (const int k : {mine, (mine + 2) % 3}) {  // the edges at the common corner
    if (edges_.is_beyond(k, b1) && edges_.is_beyond(k, b2)) {
      return TriangleOverlap::none;
    }
  }
  const Corners a = {points_[corners_[mine]], points_[corners_[(mine + 1) % 3]],
                     points_[corners_[(mine + 2) % 3]]};
  const Corners b = {a[0], b1, b2};
  const PlaneFilter plane(b[0], b[1], b[2]);
  if (common_sign(plane.side(a[1]), plane.side(a[2])) != 0) {
    return TriangleOverlap::none;
  }
  const int axis = plane_.main_axis();
  if (cones_certainly_apart(b, a, axis)) {
    return TriangleOverlap::none;
  }
  return cones_meeting(a, plane_, b, plane, axis);
}

TriangleOverlap TriangleOverlapTest::sharing_none(const Triangle& other) const {
  const Corners b = {points_[other[0]], points_[other[1]], points_[other[2]]};
  const Sides certain_b = {plane_.side(b[0]), plane_.side(b[1]), plane_.side(b[2])};
  if (common_sign(certain_b) != 0 || certainly_apart_from(b)) {
    return TriangleOverlap::none;
  }
  const Corners a = {points_[corners_[0]], points_[corners_[1]], points_[corners_[2]]};
  const PlaneFilter plane(b[0], b[1], b[2]);
  const Sides certain_a = {plane.side(a[0]), plane.side(a[1]), plane.side(a[2])};
  if (common_sign(certain_a) != 0) {
    return TriangleOverlap::none;
  }
  const auto lone_a = lone_corner(certain_a), lone_b = lone_corner(certain_b);
  if (lone_a && lone_b) {
    if (const auto meeting = certain_meeting(a, *lone_a, b, *lone_b)) {
      return *meeting;
    }
  } else if (certainly_apart(a, certain_a, b, certain_b)) {
    return TriangleOverlap::none;
  }
  const int axis = plane_.main_axis();
  if (edge_separates(b, a, axis, side_of_line)) {
    return TriangleOverlap::none;
  }
  const Sides sides_b = exact_sides(certain_b, a, b);
  if (common_sign(sides_b) != 0) {
    return TriangleOverlap::none;
  }
  const Sides sides_a = exact_sides(certain_a, b, a);
  if (common_sign(sides_a) != 0) {
    return TriangleOverlap::none;
  }
  if (const auto of_a = lone_corner(sides_a), of_b = lone_corner(sides_b); of_a && of_b) {
    return exact_meeting(a, *of_a, b, *of_b);
  }
  if (sides_b == Sides{0, 0, 0}) {
    return coplanar_meeting(a, b, projection_axis(a, axis));
  }
  auto crossing = touches(b, sides_b, a, axis);
  if (!crossing) {
    crossing = touches(a, sides_a, b, plane.main_axis());
  }
  if (!crossing) {
    crossing =
        any_edge_meets(b, sides_b, a, axis) || any_edge_meets(a, sides_a, b, plane.main_axis());
  }
  return *crossing ? TriangleOverlap::crossing : TriangleOverlap::none;
}

}  // namespace dupin::predicates
