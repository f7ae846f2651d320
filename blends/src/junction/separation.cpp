#include "junction/separation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "cyclide/exact_pe.h"
#include "numbers/angle.h"
#include "numbers/exact_vec3.h"
#include "numbers/interval.h"

namespace dupin::junction {
namespace {

using numbers::Interval;

// What is certain, whatever numbers intervals stand for. What is asked here is of such comparisons
// only, so that what they say is so; that it is not is for rational numbers to say.
bool operator>(const Interval& a, const Interval& b) { return a.lower > b.upper; }
bool operator<(const Interval& a, const Interval& b) { return b > a; }

// x |x|.
template <class Number>
Number signed_square(const Number& x) {
  const Number square = x * x;
  return x < 0 ? Number(-square) : square;
}

Interval signed_square(const Interval& x) {
  const Interval square = x * x;
  const bool has_sign = x > 0 || x < 0;
  return has_sign ? (x < 0 ? -square : square) : Interval(-square.magnitude(), square.magnitude());
}

// The same formulas in doubles, in intervals and in rational numbers.
template <class Number>
using Vector = std::array<Number, 3>;

template <class Number>
struct PePoint {
  Vector<Number> m;
  Number r;
};

template <class Number>
Vector<Number> vector(const Vec3& v) {
  return {Number(v.x()), Number(v.y()), Number(v.z())};
}

template <class Number>
PePoint<Number> point(const PeVector& b) {
  return {vector<Number>(b.m), Number(b.r)};
}

template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return Number(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

template <class Number>
Vector<Number> difference(const Vector<Number>& a, const Vector<Number>& b) {
  return {Number(a[0] - b[0]), Number(a[1] - b[1]), Number(a[2] - b[2])};
}

template <class Number>
PePoint<Number> difference(const PePoint<Number>& a, const PePoint<Number>& b) {
  return {difference(a.m, b.m), Number(a.r - b.r)};
}

template <class Number>
Number product(const PePoint<Number>& a, const PePoint<Number>& b) {
  return Number(dot(a.m, b.m) - a.r * b.r);
}

// An arc's homogeneous points are (start; 1), (e start + D tangent / 2; e), (D end; D), with d =
// end - start, D = <d, d>, e = <d, tangent>.
template <class Number>
struct ArcNumbers {
  explicit ArcNumbers(const PeArc& arc)
      : start(point<Number>(arc.start())),
        tangent(point<Number>(arc.start_tangent())),
        end(point<Number>(arc.end())),
        d(difference(end, start)),
        squared(product(d, d)),
        along(product(d, tangent)) {}

  // Times `squared`: (2 e d - D tangent).
  [[nodiscard]] PePoint<Number> end_tangent() const {
    PePoint<Number> result;
    for (std::size_t i = 0; i < 3; ++i) {
      result.m.at(i) = 2 * along * d.m.at(i) - squared * tangent.m.at(i);
    }
    result.r = 2 * along * d.r - squared * tangent.r;
    return result;
  }

  PePoint<Number> start, tangent, end, d;
  Number squared, along;
};

template <class Number>
bool caps_are_disjoint(const PeArc& a, const PeArc& b) {
  const auto one = ArcNumbers<Number>(a).end_tangent(), other = ArcNumbers<Number>(b).end_tangent();
  const Number between = product(one, other), one_squared = product(one, one),
               other_squared = product(other, other);
  // tau over its tangent's length is the cotangent of the cap's angle.
  const Number sum = signed_square(one.r) * other_squared + signed_square(other.r) * one_squared;
  const bool below_half_turn = sum > 0;
  return below_half_turn && between < 0 && between * between > one_squared * other_squared;
}

// Positive on all of [0, 1], as far as so many halvings tell.
template <class Number>
bool is_positive(const std::array<Number, 5>& c, int halvings) {
  if (!(c.front() > 0) || !(c.back() > 0)) {
    return false;
  }
  if (std::ranges::all_of(c, [](const Number& x) { return x > 0; })) {
    return true;
  }
  if (halvings == 0) {
    return false;
  }
  std::array<Number, 5> left, right, row = c;
  for (std::size_t k = 0; k < 5; ++k) {
    left.at(k) = row[0];
    right.at(4 - k) = row.at(4 - k);
    for (std::size_t i = 0; i + 1 < 5 - k; ++i) {
      row.at(i) = (row.at(i) + row.at(i + 1)) / 2;
    }
  }
  return is_positive(left, halvings - 1) && is_positive(right, halvings - 1);
}

template <class Number>
using Quadratic = std::array<Number, 3>;

template <class Number>
std::array<Number, 5> squared(const Quadratic<Number>& a) {
  return {Number(a[0] * a[0]), Number(a[0] * a[1]), Number((a[0] * a[2] + 2 * a[1] * a[1]) / 3),
          Number(a[1] * a[2]), Number(a[2] * a[2])};
}

// A plane through a point, with its normal.
template <class Number>
struct Plane {
  Vector<Number> origin, normal;

  [[nodiscard]] Number height(const Vector<Number>& p) const {
    return dot(difference(p, origin), normal);
  }
};

// D^2 (H^2 - P^2) + (P' H - H' P)^2 with the numerators H of the heights and P of the radii.
template <class Number>
bool misses(const PeArc& arc, const Plane<Number>& plane) {
  const ArcNumbers<Number> a(arc);
  const Number start = plane.height(a.start.m), rise = dot(plane.normal, a.tangent.m);
  const Quadratic<Number> h{start, Number(a.along * start + a.squared * rise / 2),
                            Number(a.squared * plane.height(a.end.m))};
  const Quadratic<Number> p{a.start.r, Number(a.along * a.start.r + a.squared * a.tangent.r / 2),
                            Number(a.squared * a.end.r)};
  const Quadratic<Number> turn{Number(2 * (p[1] * h[0] - p[0] * h[1])),
                               Number(p[2] * h[0] - p[0] * h[2]),
                               Number(2 * (p[2] * h[1] - p[1] * h[2]))};
  // The plane's normal need not be of unit length.
  const Number scale = a.squared * a.squared, length = dot(plane.normal, plane.normal);
  const auto hh = squared(h), pp = squared(p), tt = squared(turn);
  std::array<Number, 5> quartic;
  for (std::size_t i = 0; i < 5; ++i) {
    quartic.at(i) = scale * (hh.at(i) - length * pp.at(i)) + tt.at(i);
  }
  constexpr int kHalvings = 8;
  return is_positive(quartic, kHalvings);
}

// The disc lies in front of the plane: height > radius |normal x n|.
template <class Number>
bool is_before(const Ring& disc, const Plane<Number>& plane) {
  const Vector<Number> n = vector<Number>(disc.normal);
  const Number height = plane.height(vector<Number>(disc.center)), along = dot(n, plane.normal);
  const Number across = dot(plane.normal, plane.normal) * dot(n, n) - along * along;
  const Number radius(disc.radius);
  return height > 0 && height * height * dot(n, n) > radius * radius * across;
}

template <class Number>
bool is_before(const JunctionArm& arm, const Vec3& center, const Vec3& normal) {
  const Plane<Number> plane{vector<Number>(center), vector<Number>(normal)};
  // What lies between two discs is in their convex hull.
  return is_before(arm.end, plane) && is_before(circle_at(arm.collar, 0), plane) &&
         misses(arm.collar, plane);
}

Vec3 cap_axis(const PeArc& collar) { return -collar.end_tangent().m.normalized(); }

double angle_of(const PeArc& collar) { return std::atan2(1, collar.end_tangent().r); }

template <class Number>
bool goes_forward(const PeArc& collar) {
  return ArcNumbers<Number>(collar).along > 0;
}

// With q from the hub's centre to the start sphere's, the generators of the cone come nearer where
// A.q + |tau| |q - (q.A) A / |A|^2| |A| < 0, times |A|^2.
template <class Number>
bool approaches(const PeArc& collar) {
  const ArcNumbers<Number> a(collar);
  const Vector<Number> q = difference(a.start.m, a.end.m);
  const Number along = dot(a.tangent.m, q), length = dot(a.tangent.m, a.tangent.m);
  const Number across = dot(q, q) * length - along * along;
  return along < 0 && along * along > a.tangent.r * a.tangent.r * across;
}

template <class Work>
bool decided(Arithmetic arithmetic, const Work& work) {
  return arithmetic == Arithmetic::exact ? work(Interval()) || work(mpq_class()) : work(double());
}

}  // namespace

bool caps_are_disjoint(const PeArc& a, const PeArc& b, Arithmetic arithmetic) {
  return decided(arithmetic,
                 [&]<class Number>(const Number&) { return caps_are_disjoint<Number>(a, b); });
}

double cap_gap(const PeArc& a, const PeArc& b) {
  return numbers::angle_between(cap_axis(a), cap_axis(b)) - angle_of(a) - angle_of(b);
}

bool arms_are_apart(const JunctionArm& a, const JunctionArm& b, Arithmetic arithmetic) {
  const Vec3 from = cap_axis(a.collar), to = cap_axis(b.collar), center = a.collar.end().m;
  Vec3 across = to - to.dot(from) * from;
  if (across.norm() < 1e-6) {
    int smallest = 0;
    from.cwiseAbs().minCoeff(&smallest);
    across = Vec3::Unit(smallest) - from(smallest) * from;
  }
  across.normalize();
  const double first = angle_of(a.collar), gap = cap_gap(a.collar, b.collar);
  // From the middle of the gap outwards.
  for (const double share : {0.5, 0.3, 0.7, 0.1, 0.9}) {
    const double angle = first + share * gap;
    const Vec3 normal = std::sin(angle) * from - std::cos(angle) * across;
    const bool apart = decided(arithmetic, [&]<class Number>(const Number&) {
      return is_before<Number>(a, center, normal) && is_before<Number>(b, center, -normal);
    });
    if (apart) {
      return true;
    }
  }
  return false;
}

bool goes_forward(const PeArc& collar, Arithmetic arithmetic) {
  return decided(arithmetic,
                 [&]<class Number>(const Number&) { return goes_forward<Number>(collar); });
}

bool approaches(const PeArc& collar, Arithmetic arithmetic) {
  return decided(arithmetic,
                 [&]<class Number>(const Number&) { return approaches<Number>(collar); });
}

}  // namespace dupin::junction
