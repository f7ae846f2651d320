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

struct Place {
  PeVector sphere, velocity;  // by the parameter; its PE-square is b^2, b^2 / cos^2 or 1
};

Place local_place(const CanonicalPiece& piece, double s) {
  const auto& [kind, a, b, c, mu, origin, x, y, z] = piece.form;
  const double cosine = std::cos(s), sine = std::sin(s);
  if (kind == CyclideKind::parabolic) {
    const double h = s * s / (2 * a);
    return {{Vec3(h, s, 0), mu - h}, {Vec3(s / a, 1, 0), -s / a}};
  }
  if (!piece.along_hyperbola) {
    return {{Vec3(a * cosine, b * sine, 0), mu - c * cosine},
            {Vec3(-a * sine, b * cosine, 0), c * sine}};
  }
  const double secant = 1 / cosine, rate = sine * secant * secant;
  return {{Vec3(c * secant, 0, -b * sine * secant), mu - a * secant},
          {Vec3(c * rate, 0, -b * secant * secant), -a * rate}};
}

Place place(const CanonicalPiece& piece, double s) {
  const Place local = local_place(piece, s);
  const auto& f = piece.form;
  const auto turned = [&](const Vec3& v) -> Vec3 {
    return v.x() * f.x + v.y() * f.y + v.z() * f.z;
  };
  return {{f.origin + turned(local.sphere.m), local.sphere.r},
          {turned(local.velocity.m), local.velocity.r}};
}

// The parameter of the sphere with this centre.
double parameter(const CanonicalPiece& piece, const PeVector& sphere) {
  const auto& f = piece.form;
  const Vec3 v = sphere.m - f.origin;
  if (f.kind == CyclideKind::parabolic) {
    return v.dot(f.y);
  }
  if (!piece.along_hyperbola) {
    return std::atan2(v.dot(f.y) / f.b, v.dot(f.x) / f.a);
  }
  // tan and 1 / cos are in the centre and the radius; a > 0.
  const double tangent = -v.dot(f.z) / f.b, secant = (f.mu - sphere.r) / f.a;
  return std::atan2(tangent / secant, 1 / secant);
}

void refuse_straight(CyclideKind kind) {
  if (kind == CyclideKind::cone || kind == CyclideKind::cylinder) {
    throw Error(Errc::invalid_argument, "cones and cylinders have no canonical cyclide parameters");
  }
}

struct RingCoordinates {
  double kappa, c, s;
};

struct HomogeneousPoint {
  Vec3 point;
  double weight;
};

// Contact of two spheres of different families, bilinear in their homogeneous coordinates.
HomogeneousPoint contact(const HomogeneousSphere& g, const cyclide::ComplementarySphere& q) {
  return {q.radius * g.sphere.m - g.sphere.r * q.center,
          q.radius * g.weight - g.sphere.r * q.weight};
}

// cos of half the arc that a rational quadratic with these weights spans.
double half_arc_cosine(double w0, double w1, double w2) { return w1 / std::sqrt(w0 * w2); }

constexpr double kQuarterTurn = std::numbers::sqrt2 / 2;  // cos 45 deg: arcs of at most 90 degrees

bool short_enough(const PeArc& arc) {
  if (arc.w() < kQuarterTurn) {
    return false;
  }
  const auto rows = bezier_points(arc);
  const ArcFrame f = frame(arc);
  for (int k = 0; k < 16; ++k) {
    const double v = k * std::numbers::pi / 8;
    const cyclide::ComplementarySphere q =
        cyclide::complementary_sphere(arc, f, 1, std::cos(v), std::sin(v));
    const double w0 = contact(rows[0], q).weight, w1 = contact(rows[1], q).weight,
                 w2 = contact(rows[2], q).weight;
    if (!(w0 > 0 && w2 > 0 && half_arc_cosine(w0, w1, w2) >= kQuarterTurn)) {
      return false;
    }
  }
  return true;
}

BiquadraticPatch patch(const PeArc& arc, double v0, double v1) {
  const double half = (v1 - v0) / 2, middle = (v0 + v1) / 2;
  const std::array<RingCoordinates, 3> columns{
      {{1, std::cos(v0), std::sin(v0)},
       {std::cos(half), std::cos(middle), std::sin(middle)},
       {1, std::cos(v1), std::sin(v1)}}};
  const auto rows = bezier_points(arc);
  const ArcFrame f = frame(arc);
  const double scale = 1 / (arc.chord() * arc.chord());
  BiquadraticPatch result;
  for (std::size_t j = 0; j < 3; ++j) {
    const cyclide::ComplementarySphere q =
        cyclide::complementary_sphere(arc, f, columns[j].kappa, columns[j].c, columns[j].s);
    for (std::size_t i = 0; i < 3; ++i) {
      const HomogeneousPoint p = contact(rows[i], q);
      result.points[i][j] = scale * p.point;
      result.weights[i][j] = scale * p.weight;
    }
  }
  return result;
}

bool narrow_enough(const BiquadraticPatch& p) {
  return std::ranges::all_of(p.weights, [](const std::array<double, 3>& w) {
    // Rounding may leave the quarter arc of the first row a few ulp above 90 degrees.
    return w[0] > 0 && w[1] > 0 && w[2] > 0 &&
           half_arc_cosine(w[0], w[1], w[2]) >= kQuarterTurn * (1 - 1.0 / (1 << 20));
  });
}

void add_columns(const PeArc& arc, double v0, double v1, std::vector<BiquadraticPatch>& out) {
  const BiquadraticPatch p = patch(arc, v0, v1);
  if (narrow_enough(p)) {
    out.push_back(p);
    return;
  }
  const double middle = (v0 + v1) / 2;
  add_columns(arc, v0, middle, out);
  add_columns(arc, middle, v1, out);
}

void add_rows(const PeArc& arc, std::vector<BiquadraticPatch>& out) {
  if (!short_enough(arc)) {
    add_rows(sub_arc(arc, 0, 0.5), out);
    add_rows(sub_arc(arc, 0.5, 1), out);
    return;
  }
  for (int quarter = 0; quarter < 4; ++quarter) {
    add_columns(arc, quarter * std::numbers::pi / 2, (quarter + 1) * std::numbers::pi / 2, out);
  }
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

CanonicalPiece canonical_piece(const PeArc& arc) {
  CanonicalPiece piece{canonical_form(arc), arc.w() > 1, 0, 0};
  refuse_straight(piece.form.kind);
  piece.from = parameter(piece, arc.start());
  piece.to = parameter(piece, arc.end());
  if (piece.form.kind == CyclideKind::parabolic) {
    return piece;
  }
  // The way that leaves along the arc's tangent.
  const bool rises = product(place(piece, piece.from).velocity, arc.start_tangent()) > 0;
  if (rises != (piece.to > piece.from)) {
    piece.to += rises ? 2 * std::numbers::pi : -2 * std::numbers::pi;
  }
  return piece;
}

PeArc arc_of(const CanonicalPiece& piece) {
  refuse_straight(piece.form.kind);
  const double span = std::abs(piece.to - piece.from);
  const bool is_closed = piece.form.kind != CyclideKind::parabolic;
  if (!(span > 0) || (is_closed && !(span < 2 * std::numbers::pi)) ||
      (piece.along_hyperbola &&
       !(std::cos(piece.from) * std::cos(piece.to) > 0 && span < std::numbers::pi))) {
    throw Error(Errc::invalid_argument,
                "a canonical piece must not pass a whole turn or infinity, nor be empty");
  }
  const Place from = place(piece, piece.from), to = place(piece, piece.to);
  const double length = std::sqrt(product(from.velocity, from.velocity));
  const double sign = piece.to > piece.from ? 1 : -1;
  return PeArc::from(from.sphere, (sign / length) * from.velocity, to.sphere);
}

Vec3 evaluate(const BiquadraticPatch& patch, double t, double s) {
  const std::array<double, 3> bt{(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
  const std::array<double, 3> bs{(1 - s) * (1 - s), 2 * s * (1 - s), s * s};
  Vec3 point = Vec3::Zero();
  double weight = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      point += bt[i] * bs[j] * patch.points[i][j];
      weight += bt[i] * bs[j] * patch.weights[i][j];
    }
  }
  return point / weight;
}

std::vector<BiquadraticPatch> patches(const PeArc& arc) {
  std::vector<BiquadraticPatch> result;
  add_rows(arc, result);
  return result;
}

}  // namespace dupin
