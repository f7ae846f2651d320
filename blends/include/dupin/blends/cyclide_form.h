#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "dupin/blends/pe_arc.h"

namespace dupin {

/// Lateral area of a piece between its contact circles, to 1e-12 relative.
[[nodiscard]] double area(const PeArc& arc);
/// Volume between the discs of its contact circles, to 1e-12 relative.
[[nodiscard]] double volume(const PeArc& arc);

/// What surface a piece lies on. Numerically close cases are told apart by names only; no
/// construction depends on them.
enum class CyclideKind { cylinder, cone, torus, elliptic, hyperbolic, parabolic };

[[nodiscard]] std::string_view name(CyclideKind kind);

/// The canonical parameters: (x^2+y^2+z^2-mu^2+b^2)^2 = 4(ax - c mu)^2 + 4 b^2 y^2 in the frame
/// (origin; x, y, z), b^2 = a^2 - c^2; for parabolic pieces (x^2+y^2+z^2)x - (mu+p)x^2 - mu y^2 -
/// (mu+p)z^2 - mu^2 x + mu^2 (mu+p) = 0 with p in `a`. `elliptic` pieces belong to the family whose
/// spine is the ellipse, `hyperbolic` ones to the other. For cones and cylinders only origin (the
/// start sphere's centre) and x (the axis) are set.
struct CanonicalCyclide {
  CyclideKind kind = CyclideKind::cylinder;
  double a = 0, b = 0, c = 0, mu = 0;
  Vec3 origin, x, y, z;
};

[[nodiscard]] CanonicalCyclide canonical_form(const PeArc& arc);

/// Normal curvatures with respect to the outward normal: those of a sphere are 1 / radius.
struct PrincipalCurvatures {
  double around = 0;  ///< along the circles
  double along = 0;   ///< along the other lines of curvature; negative on the saddle side
};

/// At point_at(arc, t, v).
[[nodiscard]] PrincipalCurvatures curvatures_at(const PeArc& arc, double t, double v);

/// The left side minus the right side of the canonical equation at a point of the assembly frame;
/// zero on the surface. Requires a kind other than cone and cylinder; throws
/// Error{invalid_argument} otherwise.
[[nodiscard]] double implicit_value(const CanonicalCyclide& form, const Vec3& point);

/// The smallest radius of the arc's spheres.
[[nodiscard]] double least_radius(const PeArc& arc);

/// Largest delta such that the tube (the union of the arc's balls) keeps distance delta from
/// `point`: outside the distance from the tube, inside minus the depth in the ball that the point
/// lies deepest in. Absolute error below 1e-12 of the size of the data.
[[nodiscard]] double signed_distance(const PeArc& arc, const Vec3& point);

/// A piece by canonical parameters. Along the ellipse or torus circle (theta): centre (a cos, b
/// sin, 0), radius mu - c cos; along the hyperbola (psi): centre (c / cos, 0, -b tan), radius mu -
/// a / cos; along the parabola (t): centre (t^2 / 2p, t, 0), radius mu - t^2 / 2p.
struct CanonicalPiece {
  CanonicalCyclide form;
  bool along_hyperbola = false;
  double from = 0, to = 1;  ///< the parameter at the ends; the piece runs from one to the other
};

/// Requires a kind other than cone and cylinder; throws Error{invalid_argument} otherwise.
[[nodiscard]] CanonicalPiece canonical_piece(const PeArc& arc);

/// The other way round. Throws Error{invalid_argument} for cones, cylinders and pieces that pass a
/// whole turn or infinity, Error{infeasible_blend} where the piece is not regular.
[[nodiscard]] PeArc arc_of(const CanonicalPiece& piece);

/// A rational biquadratic Bezier patch: 3 x 3 homogeneous control points (w x, w y, w z, w), rows
/// along the spine.
struct BiquadraticPatch {
  std::array<std::array<Vec3, 3>, 3> points;       ///< w times the point
  std::array<std::array<double, 3>, 3> weights{};  ///< positive
};

[[nodiscard]] Vec3 evaluate(const BiquadraticPatch& patch, double t, double s);

/// The exact piece as patches with positive weights and boundary arcs of at most 90 degrees, row by
/// row (along the spine), four or more columns around.
[[nodiscard]] std::vector<BiquadraticPatch> patches(const PeArc& arc);

/// A circle in the plane of symmetry of a piece that touches all of its spheres. The radius is
/// positive where the circle encloses them, negative where it lies outside of them.
struct BoundingCircle {
  Vec3 center = Vec3::Zero();
  double radius = 1;
};

/// The two circles in which the plane of symmetry meets the piece's surface, on the side of
/// frame(arc).first first; of a piece of revolution, in the plane of that frame. Of regular
/// elliptic pieces one encloses the spheres, of hyperbolic ones both or neither.
///
/// Throws Error{invalid_argument} where one is a line.
[[nodiscard]] std::array<BoundingCircle, 2> bounding_circles(const PeArc& arc);

/// The cyclide with these bounding circles in a plane of this unit normal: `elliptic` if the
/// radii differ by more than the centres, `hyperbolic` otherwise. Throws Error{invalid_argument}
/// unless one of both differs.
[[nodiscard]] CanonicalCyclide canonical_form(const BoundingCircle& one,
                                              const BoundingCircle& other,
                                              const Vec3& plane_normal);

}  // namespace dupin
