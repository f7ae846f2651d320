#include "arrangement/points/implicit_predicates.h"

#include <algorithm>
#include <cmath>

#include "exact/vector_algebra.h"
#include "mesh/radial_order.h"
#include "predicates/lattice_orientation.h"

namespace dupin::arrangement {
namespace {

using exact::difference;
using exact::direction;

using Number = CGAL::Mpzf;

// Stage A of [She97] bounds the error of the determinant by (7 + 56 u) u times its permanent, u the
// largest relative error of one operation. Here rounding is upward, so u = 2^-52; the 8 instead of
// 7 pays for computing the permanent itself in floating point. The addend covers underflow of
// products; overflow gives infinities or NaN, which are never certain.
constexpr double kSideBound = 8 * 0x1p-52;
constexpr double kUnderflow = 0x1p-900;

template <class N>
N determinant(const std::array<N, 3>& u, const std::array<N, 3>& v, const std::array<N, 3>& w) {
  return exact::dot(w, exact::cross(u, v));
}

int exact_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  if (const auto sign = predicates::lattice_orientation(a, b, c, p)) {
    return *sign;
  }
  const std::array<Number, 3> origin{Number(a[0]), Number(a[1]), Number(a[2])};
  const auto from_origin = [&origin](const Vec3& q) {
    return std::array<Number, 3>{Number(q[0]) - origin[0], Number(q[1]) - origin[1],
                                 Number(q[2]) - origin[2]};
  };
  return determinant(from_origin(b), from_origin(c), from_origin(p)).sign();
}

template <class N>
FilteredSign side_of(const std::array<N, 3>& a, const std::array<N, 3>& b,
                     const std::array<N, 3>& c, const std::array<N, 3>& p) {
  return sign_of(determinant(difference(b, a), difference(c, a), difference(p, a)));
}

int implicit_side(const PointTable& points, PointId a, PointId b, PointId c, PointId p) {
  FilteredSign filtered =
      side_of(points.interval(a), points.interval(b), points.interval(c), points.interval(p));
  if (!filtered.certain) {
    filtered = side_of(points.ball(a), points.ball(b), points.ball(c), points.ball(p));
  }
  if (filtered.certain) {
    return filtered.sign;
  }
  std::array<mesh::ExactPoint, 4> scratch;
  const mesh::ExactPoint& o = points.exact(a, scratch[0]);
  return determinant(direction(o, points.exact(b, scratch[1])),
                     direction(o, points.exact(c, scratch[2])),
                     direction(o, points.exact(p, scratch[3])))
      .sign();
}

}  // namespace

PlaneSides::PlaneSides(const PointTable& points, PointId a, PointId b, PointId c)
    : points_(points), of_{a, b, c} {
  is_of_doubles_ = points.is_double(a) && points.is_double(b) && points.is_double(c);
  if (!is_of_doubles_) {
    return;
  }
  origin_ = points.coordinates(a);
  const Vec3 &q = points.coordinates(b), &r = points.coordinates(c);
  const double bx = q[0] - origin_[0], by = q[1] - origin_[1], bz = q[2] - origin_[2];
  const double cx = r[0] - origin_[0], cy = r[1] - origin_[1], cz = r[2] - origin_[2];
  const double yz = by * cz, zy = bz * cy, zx = bz * cx, xz = bx * cz, xy = bx * cy, yx = by * cx;
  normal_ = {yz - zy, zx - xz, xy - yx};
  size_ = {std::abs(yz) + std::abs(zy), std::abs(zx) + std::abs(xz), std::abs(xy) + std::abs(yx)};
}

// Of all points that differ from `p` by at most `reach` in each coordinate, 0 if they do not agree.
// A difference d changes the determinant by normal . d, and the sums of absolute products are no
// less than the normal's coordinates but for a few of their roundings.
int PlaneSides::filtered(const Vec3& p, const Vec3& reach) const {
  const double px = p[0] - origin_[0], py = p[1] - origin_[1], pz = p[2] - origin_[2];
  const double value = px * normal_[0] + py * normal_[1] + pz * normal_[2];
  const double permanent =
      std::abs(px) * size_[0] + std::abs(py) * size_[1] + std::abs(pz) * size_[2];
  const double moved = reach[0] * size_[0] + reach[1] * size_[1] + reach[2] * size_[2];
  const double bound = kSideBound * permanent + kUnderflow + moved * (1 + 0x1p-40);
  return (value > bound) - (value < -bound);
}

int PlaneSides::of(PointId p) const {
  const auto& [a, b, c] = of_;
  if (p == a || p == b || p == c || a == b || b == c || c == a) {
    return 0;
  }
  if (is_of_doubles_ && points_.is_double(p)) {
    const Vec3& q = points_.coordinates(p);
    if (const int sign = filtered(q, Vec3::Zero()); sign != 0) {
      return sign;
    }
    const Vec3 &y = points_.coordinates(b), &z = points_.coordinates(c);
    return q == origin_ || q == y || q == z ? 0 : exact_side(origin_, y, z, q);
  }
  const int sign = of_enclosed(p);
  return sign != 0 ? sign : implicit_side(points_, a, b, c, p);
}

int PlaneSides::of_enclosed(PointId p) const {
  if (!is_of_doubles_) {
    return 0;
  }
  const Vec3 q = points_.approximation(p);
  Vec3 reach;
  for (int k = 0; k < 3; ++k) {
    const Interval at = points_.interval(p, k);
    reach[k] = std::max(at.sup() - q[k], q[k] - at.inf());  // rounded upward
  }
  return filtered(q, reach);
}

int side_of_plane(const PointTable& points, PointId a, PointId b, PointId c, PointId p) {
  return PlaneSides(points, a, b, c).of(p);
}

FilteredSign turn_of(const exact::BallPoint& a, const exact::BallPoint& b,
                     const exact::BallPoint& c, int axis) {
  const auto u = static_cast<std::size_t>((axis + 1) % 3);
  const auto v = static_cast<std::size_t>((axis + 2) % 3);
  return sign_of((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]));
}

int exact_turn(const mesh::ExactPoint& a, const mesh::ExactPoint& b, const mesh::ExactPoint& c,
               int axis) {
  const auto u = static_cast<std::size_t>((axis + 1) % 3);
  const auto v = static_cast<std::size_t>((axis + 2) % 3);
  const Number bu = b[u] * a[3] - a[u] * b[3], bv = b[v] * a[3] - a[v] * b[3];
  const Number cu = c[u] * a[3] - a[u] * c[3], cv = c[v] * a[3] - a[v] * c[3];
  return (bu * cv - bv * cu).sign();
}

int exact_compare(const mesh::ExactPoint& a, const mesh::ExactPoint& b, int axis) {
  const auto k = static_cast<std::size_t>(axis);
  return (a[k] * b[3] - b[k] * a[3]).sign();
}

int turn(const PointTable& points, PointId a, PointId b, PointId c, int axis) {
  if (a == b || b == c || c == a) {
    return 0;
  }
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const Interval x = points.interval(a, u), y = points.interval(a, v);
  FilteredSign filtered = sign_of((points.interval(b, u) - x) * (points.interval(c, v) - y) -
                                  (points.interval(b, v) - y) * (points.interval(c, u) - x));
  if (!filtered.certain) {
    filtered = turn_of(points.ball(a), points.ball(b), points.ball(c), axis);
  }
  if (filtered.certain) {
    return filtered.sign;
  }
  std::array<mesh::ExactPoint, 3> scratch;
  return exact_turn(points.exact(a, scratch[0]), points.exact(b, scratch[1]),
                    points.exact(c, scratch[2]), axis);
}

int compare(const PointTable& points, PointId a, PointId b, int axis) {
  if (a == b) {
    return 0;
  }
  FilteredSign filtered = sign_of(points.interval(a, axis) - points.interval(b, axis));
  if (!filtered.certain) {
    const auto k = static_cast<std::size_t>(axis);
    filtered = sign_of(points.ball(a)[k] - points.ball(b)[k]);
  }
  if (filtered.certain) {
    return filtered.sign;
  }
  mesh::ExactPoint a_scratch, b_scratch;
  return exact_compare(points.exact(a, a_scratch), points.exact(b, b_scratch), axis);
}

bool coincide(const PointTable& points, PointId a, PointId b) {
  return points.are_defined_alike(a, b) ||
         (compare(points, a, b, 0) == 0 && compare(points, a, b, 1) == 0 &&
          compare(points, a, b, 2) == 0);
}

namespace {

// +1 if turning counter-clockwise by less than a half turn leads from `from` to `to`, -1 if turning
// clockwise does, 0 if they are opposite. The front of one that runs forward lies ahead of it.
int ahead(const ArrangementInput& input, const HalfPlane& from, const HalfPlane& to) {
  const Triangle& plane = input.support(from.support);
  if (plane == input.support(to.support)) {
    return 0;  // opposite in one plane
  }
  const int side = side_of_plane(input.points, plane[0], plane[1], plane[2], to.apex);
  return from.forward ? side : -side;
}

}  // namespace

void order_facets_around_edge(const ArrangementInput& input, std::vector<HalfPlane>& half_planes) {
  mesh::sort_around_edge(
      half_planes,
      [&input](const HalfPlane& from, const HalfPlane& to) { return ahead(input, from, to); },
      [](const HalfPlane&, const HalfPlane&) { return true; });
}

}  // namespace dupin::arrangement
