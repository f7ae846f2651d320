#include "dupin/blends/canonical_piece.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "dupin/kernel/error.h"

namespace dupin {
namespace {

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

}  // namespace

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

}  // namespace dupin
