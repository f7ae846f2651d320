#include "dupin/blends/cyclide_form.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "cyclide/complementary_sphere.h"
#include "dupin/kernel/error.h"
#include "numbers/golden_section.h"
#include "numbers/quadrature.h"

namespace dupin {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

PeVector curvature_vector(const PeArc& arc) {
  const double length = arc.chord();
  return (2 / (length * length)) *
         (arc.end() - arc.start() - (arc.w() * length) * arc.start_tangent());
}

// Integrates f(sphere, tau, g, 1 + tau^2) over the PE arc length; g is the derivative of spherical
// arc along the tube.
template <class Function>
double integrate(const PeArc& arc, Function f) {
  const PeVector k0 = curvature_vector(arc);
  const double kk = 4 * (1 - arc.w() * arc.w()) / (arc.chord() * arc.chord());
  const auto integrand = [&](double t) {
    const PeVector sphere = sphere_at(arc, t), tangent = tangent_at(arc, t);
    const PeVector k = k0 - kk * (sphere - arc.start());
    const double stretch2 = 1 + tangent.r * tangent.r;
    const double g = (1 - sphere.r * k.r / stretch2) / std::sqrt(stretch2);
    const double weight = (1 - t) * (1 - t) + 2 * arc.w() * t * (1 - t) + t * t;
    return f(sphere.r, g, stretch2) * arc.chord() / weight;
  };
  // The integrand has its poles where the weight vanishes, the nearer to [0, 1] the more the arc
  // turns: pieces by turning.
  const int pieces = arc.w() >= 0 ? 2 : 8 + static_cast<int>(8 / (1 + arc.w()));
  return numbers::integral(integrand, numbers::gauss_panels(pieces));
}

Vec3 any_orthogonal(const Vec3& axis) {
  int smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  return axis.cross(Vec3::Unit(smallest)).normalized();
}

CanonicalCyclide parabolic(const PeArc& arc, const PeVector& k) {
  const double s = -arc.start_tangent().r / k.r;
  const PeVector vertex = arc.start() + s * arc.start_tangent() + (s * s / 2) * k;
  const Vec3 y = (arc.start_tangent() + s * k).m.normalized();
  const double kappa = k.m.norm();
  const double sign = k.r < 0 ? 1 : -1;
  const Vec3 x = sign / kappa * k.m;
  return {CyclideKind::parabolic, sign / kappa, 0, 0, vertex.r, vertex.m, x, y, x.cross(y)};
}

CanonicalCyclide elliptic(const PeArc& arc, const PeVector& k, double kk) {
  const PeVector &b0 = arc.start(), &t0 = arc.start_tangent();
  const double b = 1 / std::sqrt(kk);
  const PeVector unit = b * k, centre = b0 + (1 / kk) * k;
  const double h = std::hypot(t0.r, unit.r);
  if (b * h <= 16 * kEpsilon * (b + std::abs(b0.r))) {
    const Vec3 x = -unit.m.normalized(), y = t0.m.normalized();
    return {CyclideKind::torus, b, b, 0, centre.r, centre.m, x, y, x.cross(y)};
  }
  const PeVector f1 = (1 / h) * (t0.r * t0 + unit.r * unit);
  const PeVector f2 = (1 / h) * (unit.r * t0 - t0.r * unit);
  const Vec3 x = -f1.m.normalized(), y = f2.m.normalized();
  return {CyclideKind::elliptic, b * f1.m.norm(), b, b * h, centre.r, centre.m, x, y, x.cross(y)};
}

CanonicalCyclide hyperbolic(const PeArc& arc, const PeVector& k, double kk) {
  const PeVector &b0 = arc.start(), &t0 = arc.start_tangent();
  const double b = 1 / std::sqrt(-kk);
  const PeVector unit = b * k, centre = b0 + (1 / kk) * k;
  const double g = std::sqrt((unit.r - t0.r) * (unit.r + t0.r));
  const PeVector f2 = (1 / g) * (unit.r * t0 - t0.r * unit);
  PeVector f1 = (1 / g) * (unit.r * unit - t0.r * t0);
  if (product(b0 - centre, f1) > 0) {
    f1 = -1 * f1;
  }
  const PeVector e = f1.r < 0 ? f1 : -1 * f1;
  const Vec3 z = f2.m.normalized();
  if (is_revolution(arc)) {
    const Vec3 x = any_orthogonal(z);
    return {CyclideKind::torus, b, b, 0, centre.r, centre.m, x, z.cross(x), z};
  }
  const Vec3 x = e.m.normalized();
  return {CyclideKind::hyperbolic,
          b * std::abs(f1.r),
          b,
          b * e.m.norm(),
          centre.r,
          centre.m,
          x,
          z.cross(x),
          z};
}

// The places x = t / (1 - t) > 0 where a (1 - t)^2 + 2 b t (1 - t) + c t^2 vanishes, that is c x^2
// + 2 b x + a, without cancellation; as t, ascending.
std::vector<double> inner_zeros(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  std::vector<double> zeros;
  if (discriminant >= 0) {
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    for (const double x : {q / c, a / q}) {
      if (x > 0 && std::isfinite(x)) {
        zeros.push_back(x / (1 + x));
      }
    }
  }
  std::sort(zeros.begin(), zeros.end());
  return zeros;
}

struct RadiusRange {
  double least = 0, largest = 0;
};

// r = R / W with quadratics R (Bernstein r0, r1, r2) and W (1, w, 1); R' W - R W' has the
// Bernstein coefficients a, b, c.
RadiusRange radius_range(const PeArc& arc) {
  const auto p = bezier_points(arc);
  const double w = arc.w(), r0 = p[0].sphere.r, r1 = p[1].sphere.r, r2 = p[2].sphere.r;
  RadiusRange range{std::min(r0, r2), std::max(r0, r2)};
  for (const double t : inner_zeros(r1 - w * r0, (r2 - r0) / 2, w * r2 - r1)) {
    const double r = sphere_at(arc, t).r;
    range = {std::min(range.least, r), std::max(range.largest, r)};
  }
  return range;
}

// Bernstein coefficients of a quadratic on [0, 1], and its polar form.
struct Quadratic {
  double c0 = 0, c1 = 0, c2 = 0;

  [[nodiscard]] double polar(double a, double b) const {
    return (1 - a) * (1 - b) * c0 + (a * (1 - b) + b * (1 - a)) * c1 + a * b * c2;
  }

  [[nodiscard]] bool is_positive(double a, double b) const {
    const double at_a = polar(a, a), middle = polar(a, b), at_b = polar(b, b);
    return at_a > 0 && at_b > 0 && (middle > 0 || middle * middle < at_a * at_b);
  }

  // Where on [a, b], as a share of it, the quadratic that just fails to be positive vanishes.
  [[nodiscard]] double lowest(double a, double b) const {
    const double at_a = std::sqrt(std::max(0.0, polar(a, a)));
    const double at_b = std::sqrt(std::max(0.0, polar(b, b)));
    return at_a + at_b > 0 ? at_a / (at_a + at_b) : 0.5;
  }
};

// Where a ball of the arc reaches the point, if all radii grow by delta; those that shrink to
// nothing are gone. <gamma - P, gamma - P> W with P = (x; -delta) is a quadratic that is positive
// where a ball, of positive radius, does not.
std::optional<double> reaching_ball(const PeArc& arc, const Vec3& point, double delta) {
  const PeVector p{point, -delta};
  const double c0 = squared_tangential_distance(arc.start(), p);
  const Quadratic distance{
      c0, arc.w() * c0 + arc.chord() * product(arc.start_tangent(), arc.start() - p),
      squared_tangential_distance(arc.end(), p)};
  const auto b = bezier_points(arc);
  const Quadratic radius{b[0].sphere.r + delta, b[1].sphere.r + delta * arc.w(),
                         b[2].sphere.r + delta};
  std::vector<double> ends = inner_zeros(radius.c0, radius.c1, radius.c2);
  ends.insert(ends.begin(), 0);
  ends.push_back(1);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double from = ends[i], to = ends[i + 1], middle = (from + to) / 2;
    if (radius.polar(middle, middle) > 0 && !distance.is_positive(from, to)) {
      return from + distance.lowest(from, to) * (to - from);
    }
  }
  return std::nullopt;
}

}  // namespace

double area(const PeArc& arc) {
  return integrate(arc, [](double r, double g, double) { return 2 * std::numbers::pi * r * g; });
}

double volume(const PeArc& arc) {
  return integrate(arc, [](double r, double g, double stretch2) {
    return std::numbers::pi * r * r * g / stretch2;
  });
}

std::string_view name(CyclideKind kind) {
  switch (kind) {
    case CyclideKind::cylinder:
      return "cylinder";
    case CyclideKind::cone:
      return "cone";
    case CyclideKind::torus:
      return "torus";
    case CyclideKind::elliptic:
      return "elliptic cyclide";
    case CyclideKind::hyperbolic:
      return "hyperbolic cyclide";
    case CyclideKind::parabolic:
      return "parabolic cyclide";
  }
  return "unknown";
}

CanonicalCyclide canonical_form(const PeArc& arc) {
  const PeVector k = curvature_vector(arc);
  const double length = arc.chord();
  const double size = std::hypot(k.m.norm(), k.r) * length;
  // K L is the turning of the arc; below the rounding of its own cancellation there is none.
  const double noise = 64 * kEpsilon * (1 + (arc.end() - arc.start()).m.norm() / length);
  if (size <= noise) {
    const Vec3 axis = arc.start_tangent().m.normalized(), y = any_orthogonal(axis);
    const CyclideKind kind =
        std::abs(arc.start_tangent().r) <= noise ? CyclideKind::cylinder : CyclideKind::cone;
    return {kind, 0, 0, 0, arc.start().r, arc.start().m, axis, y, axis.cross(y)};
  }
  const double kk = 4 * (1 - arc.w()) * (1 + arc.w()) / (length * length);
  if (std::abs(kk) * length * length <= noise) {
    return parabolic(arc, k);
  }
  return kk > 0 ? elliptic(arc, k, kk) : hyperbolic(arc, k, kk);
}

PrincipalCurvatures curvatures_at(const PeArc& arc, double t, double v) {
  const cyclide::ComplementarySphere q =
      cyclide::complementary_sphere(arc, frame(arc), 1, std::cos(v), std::sin(v));
  return {1 / sphere_at(arc, t).r, q.weight / q.radius};
}

double implicit_value(const CanonicalCyclide& f, const Vec3& point) {
  if (f.kind == CyclideKind::cone || f.kind == CyclideKind::cylinder) {
    throw Error(Errc::invalid_argument, "cones and cylinders have no canonical cyclide equation");
  }
  const Vec3 q = point - f.origin;
  const double x = q.dot(f.x), y = q.dot(f.y), z = q.dot(f.z), square = q.squaredNorm();
  if (f.kind == CyclideKind::parabolic) {
    const double p = f.a, mu = f.mu;
    return square * x - (mu + p) * x * x - mu * y * y - (mu + p) * z * z - mu * mu * x +
           mu * mu * (mu + p);
  }
  const double s = square - f.mu * f.mu + f.b * f.b, u = f.a * x - f.c * f.mu;
  return s * s - 4 * u * u - 4 * f.b * f.b * y * y;
}

double least_radius(const PeArc& arc) { return radius_range(arc).least; }

// The bisection finds the ball to half the digits, where the depth of its centre is asked; the
// search beside it, all.
double signed_distance(const PeArc& arc, const Vec3& point) {
  double high = (point - arc.start().m).norm() - arc.start().r;
  double low = -radius_range(arc).largest, at = 0;
  const double size =
      (arc.end().m - arc.start().m).norm() + arc.start().r + arc.end().r + high - low;
  while (high - low > kEpsilon * size) {
    const double middle = low + (high - low) / 2;
    const auto reached = reaching_ball(arc, point, middle);
    (reached ? high : low) = middle;
    at = reached.value_or(at);
  }
  const auto distance = [&](double t) {
    const PeVector ball = sphere_at(arc, t);
    return (ball.m - point).norm() - ball.r;
  };
  constexpr double kBeside = 0x1p-10;
  constexpr int kSections = 64;
  const auto found = numbers::golden_section(distance, std::max(0.0, at - kBeside),
                                             std::min(1.0, at + kBeside), kSections);
  return std::min({found.value, distance(at), distance(0), distance(1)});
}

}  // namespace dupin
