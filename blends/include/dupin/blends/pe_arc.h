#pragma once

#include <array>

#include "dupin/kernel/ring.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// A vector of the pseudo-Euclidean space R^{3,1}; an oriented sphere (centre m, signed radius r)
/// is a point of it.
struct PeVector {
  Vec3 m = Vec3::Zero();
  double r = 0;

  friend bool operator==(const PeVector&, const PeVector&) = default;
};

[[nodiscard]] PeVector operator+(const PeVector& a, const PeVector& b);
[[nodiscard]] PeVector operator-(const PeVector& a, const PeVector& b);
[[nodiscard]] PeVector operator*(double s, const PeVector& a);

/// <a, b> = a.m . b.m - a.r b.r.
[[nodiscard]] double product(const PeVector& a, const PeVector& b);

/// <a - b, a - b>, the squared tangential distance of two oriented spheres, without cancellation:
/// negative when one contains the other, zero at oriented contact.
[[nodiscard]] double squared_tangential_distance(const PeVector& a, const PeVector& b);

/// The sphere that touches, along `ring`, the right circular cone of the ring's slope; positive
/// radius.
[[nodiscard]] PeVector contact_sphere(const Ring& ring);

/// The PE-unit direction of that cone, travelling along the ring's normal: (sqrt(1 + q^2) n; q).
[[nodiscard]] PeVector contact_tangent(const Ring& ring);

/// The circle along which sphere `b` touches the cone of PE-unit direction `tangent`; the normal
/// points in travel direction.
[[nodiscard]] Ring contact_ring(const PeVector& b, const PeVector& tangent);

/// Why a PE-arc is not a tube: the inequalities V1 to V4 of docs/geometry.md, in this order.
enum class ArcFault {
  none,
  nested,            ///< V1: one end sphere contains the other
  through_infinity,  ///< V2: the arc leaves in the wrong direction and would pass through infinity
  radius_vanishes,   ///< V3: the spheres of the arc shrink to nothing
  pinched,  ///< V4: the start circle reaches into the end sphere: the bend is too tight for its
            ///< radius
};

/// The four numbers that decide whether a PE-arc is a regular embedded tube. The fault is decided
/// exactly on the given doubles
/// (`tangent` is taken to be PE-unit), the numbers are rounded.
struct ArcValidity {
  ArcFault fault = ArcFault::none;
  double squared_length = 0;  ///< V1: <d, d> > 0 with d = end - start
  double w = 0;               ///< V2: <d, T0> / sqrt<d, d> > -1
  double radius_margin = 0;   ///< V3: w r0 + sqrt<d, d> tau0 / 2 + sqrt(r0 r2) > 0
  double least_power =
      0;  ///< V4: least power of a point of the start circle with respect to the end sphere, > 0
};

/// Throws Error{invalid_argument} for numbers that are not finite.
[[nodiscard]] ArcValidity validity(const PeVector& start, const PeVector& tangent,
                                   const PeVector& end);
/// The same with the fault decided on the rounded numbers: for searches, without rational
/// arithmetic.
[[nodiscard]] ArcValidity rounded_validity(const PeVector& start, const PeVector& tangent,
                                           const PeVector& end);

/// A piece of a Dupin cyclide (ring, horned, spindle, parabolic), torus, cone or cylinder: the
/// envelope of the spheres of a conic arc in R^{3,1}, regular and embedded. [SD94] TCCT; the
/// construction holds every degenerate case with none apart.
class PeArc {
 public:
  /// The unique piece that leaves sphere `start` along the PE-unit `tangent` and ends in sphere
  /// `end`; both radii positive. Throws Error{infeasible_blend} naming the violated inequality and
  /// its value.
  [[nodiscard]] static PeArc from(const PeVector& start, const PeVector& tangent,
                                  const PeVector& end);

  [[nodiscard]] const PeVector& start() const { return start_; }
  [[nodiscard]] const PeVector& end() const { return end_; }
  [[nodiscard]] const PeVector& start_tangent() const { return start_tangent_; }
  [[nodiscard]] const PeVector& end_tangent() const { return end_tangent_; }  ///< PE-unit
  [[nodiscard]] double chord() const { return chord_; }                       ///< L = sqrt<d, d>
  [[nodiscard]] double w() const {
    return w_;
  }  ///< middle weight: |w| < 1 elliptic, > 1 hyperbolic, 1 straight or parabolic
  [[nodiscard]] double least_power() const { return least_power_; }

  friend bool operator==(const PeArc&, const PeArc&) = default;

 private:
  PeArc() = default;

  PeVector start_, start_tangent_, end_, end_tangent_;
  double chord_ = 0, w_ = 1, least_power_ = 0;
};

/// A homogeneous sphere (w m; w r; w).
struct HomogeneousSphere {
  PeVector sphere;
  double weight = 1;
};

/// The homogeneous Bezier points of the arc, weights 1, w, 1; the middle one may have weight zero
/// or less.
[[nodiscard]] std::array<HomogeneousSphere, 3> bezier_points(const PeArc& arc);

[[nodiscard]] PeVector sphere_at(const PeArc& arc, double t);
/// PE-unit.
[[nodiscard]] PeVector tangent_at(const PeArc& arc, double t);
/// The contact circle at t, its normal in travel direction.
[[nodiscard]] Ring circle_at(const PeArc& arc, double t);
/// Length of the arc in R^{3,1} (the tangential length, invariant under offsets).
[[nodiscard]] double pe_length(const PeArc& arc);

/// The part of the arc for parameters [a, b] of [0, 1], a < b.
[[nodiscard]] PeArc sub_arc(const PeArc& arc, double a, double b);
[[nodiscard]] PeArc reversed(const PeArc& arc);
/// The parallel piece at distance `h` along the outward normal. Throws Error{infeasible_blend} when
/// it is not regular.
[[nodiscard]] PeArc offset(const PeArc& arc, double h);

/// True if the piece is one of revolution about its start axis, up to the rounding of the data: it
/// has no symmetry plane of its own, so that any frame is right and noise must choose none.
[[nodiscard]] bool is_revolution(const PeArc& arc);

/// The orthonormal frame at the start: axis = travel direction, second = normal of the plane of
/// symmetry, first = second x axis.
struct ArcFrame {
  Vec3 axis, first, second;
};
[[nodiscard]] ArcFrame frame(const PeArc& arc);

/// A point of the surface and its outward unit normal.
struct ArcPoint {
  Vec3 position, normal;
};

/// The point on the line of curvature that leaves the start circle at angle v (from frame().first
/// towards second).
[[nodiscard]] ArcPoint point_at(const PeArc& arc, double t, double v);

}  // namespace dupin
