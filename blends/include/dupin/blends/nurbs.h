#pragma once

#include <array>
#include <optional>
#include <vector>

#include "dupin/blends/canal_fillet.h"
#include "dupin/blends/part_surface.h"
#include "dupin/kernel/ring.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// A tensor-product NURBS surface: rows of control points along a part, columns around it.
struct NurbsSurface {
  int degree_along = 1, degree_around = 2;
  /// With end knots repeated degree + 1 times, from 0 to 1; as many as points and degree + 1.
  std::vector<double> knots_along, knots_around;
  std::vector<std::vector<std::array<double, 4>>> net;  ///< (x w, y w, z w, w), all w > 0
};

/// Its point at parameters in [0, 1].
[[nodiscard]] Vec3 evaluate(const NurbsSurface& surface, double along, double around);

/// A closed NURBS curve.
struct NurbsCurve {
  int degree = 2;
  std::vector<double> knots;               ///< as of a surface
  std::vector<std::array<double, 4>> net;  ///< (x w, y w, z w, w), all w > 0
};

/// Its point at a parameter in [0, 1].
[[nodiscard]] Vec3 evaluate(const NurbsCurve& curve, double t);

/// A ring's circle or ellipse, counter-clockwise about its normal; exact up to the rounding of the
/// control points.
[[nodiscard]] NurbsCurve nurbs(const Ring& ring);

/// The lateral surface of a part.
struct NurbsForm {
  std::vector<NurbsSurface> surfaces;
  /// No point of the NURBS is further from the part's surface than this; 0: they are the same, up
  /// to the rounding of the control points.
  double error_bound = 0;
  /// Where the part ends on the surfaces, if it is less than these: it lies to the left, seen from
  /// outside.
  std::vector<NurbsCurve> trims = {};
};

/// Exact, as the papers' surfaces are rational: cylinders, cones and elbows of any section,
/// spheres, straight blends with polynomial radii, rational ringed surfaces (bidegree (9, 2) or (5,
/// 2)) and pieces of cyclides (2, 2); of a chain with kneecaps the pieces and the whole spheres at
/// the joints, which trim each other.
///
/// Others have no exact form, because |y'| is irrational: cyclic blends, splines, elliptic blends.
/// They are lofted through their own circles by cubics that share the tangent planes of the part
/// there, refined until the bound, by interval arithmetic, is at most `tolerance`. Throws
/// Error{limit_exceeded} if more than 4096 cubics are needed.
[[nodiscard]] NurbsForm nurbs(const PartSurface& surface, double tolerance);

/// Homogeneous control points (x w, y w, z w, w) of a rational Bezier patch: three rows across the
/// arcs, from the foot on the first quadric to that on the second, of degree 10 along the loop.
using CanalNet = std::array<std::array<std::array<double, 4>, 11>, 3>;

/// The fillet as four exact patches, up to the rounding of the control points, from -pi to pi in
/// quarters (mathematics B.8): for rational fillets of constant size between two cylinders whose
/// axes meet at right angles, within rounding. None for others.
[[nodiscard]] std::optional<std::array<CanalNet, 4>> exact_nets(const CanalFillet& fillet);

/// A loop of a fillet: rows of control points along it, columns on its arcs from the first foot to
/// the second. Rational fillets of constant size between cylinders at right angles are exact, in
/// four quarters of bidegree (10, 2) (`exact_nets`). Others are arcs lofted by cubics with
/// continuous tangents, halved until the bound, by fourth derivatives in intervals, is at most
/// `tolerance`: one surface, or one from corner to corner. Throws Error{limit_exceeded} if more
/// than 4096 cubics are needed.
[[nodiscard]] NurbsForm nurbs(const CanalFillet& loop, double tolerance);

}  // namespace dupin
