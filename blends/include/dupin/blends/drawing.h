#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "dupin/blends/assembly.h"
#include "dupin/blends/build.h"
#include "dupin/blends/part_surface.h"
#include "dupin/kernel/crease.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/view.h"

namespace dupin {

/// A point of a surface whose unit normal, outward, is at right angles to the direction of view.
struct ContourPoint {
  Vec3 position, normal;
  /// Of the surface along the direction, by differences: positive where it curves away from the
  /// normal, as a ball does. Where it is negative the surface itself hides its contour.
  double curvature = 0;
};

/// Points along a contour, in order.
using ContourCurve = std::vector<ContourPoint>;

/// Where the surface's normals are at right angles to `direction`: what bounds its picture, and
/// where its front turns to its back ([MS06]; mathematics A10). Whether other surfaces, or other
/// places of its own, hide it is not asked. Segments of the polylines are within `tolerance` of the
/// curve. Loops smaller than a 32nd of the way around and along a piece may be missed; where a
/// whole region's normals are at right angles, as of a cylinder seen along its axis, there is none,
/// but along the rim of a surface that goes on from there.
/// Throws Error{invalid_argument} for a direction that is zero or not finite and for a tolerance
/// that is not positive.
[[nodiscard]] std::vector<ContourCurve> contours(const PartSurface& surface, const Vec3& direction,
                                                 double tolerance);

struct DrawingOptions {
  View view;
  bool hidden = false;  ///< whether lines are drawn that the solid hides
  bool center = false;  ///< whether the axes of round parts are drawn
};

enum class LineKind {
  contour,  ///< of a smooth surface
  edge,     ///< where two surfaces meet and the solid turns
  center,   ///< of circles: an axis, or the cross of one seen along it; through all that is before
            ///< it
};

/// A line in the picture, x to the right and y upwards.
struct DrawnLine {
  std::string part;  ///< what it belongs to: the part of the surface, or one of two that meet
  LineKind kind = LineKind::contour;
  bool hidden = false;
  std::vector<Eigen::Vector2d> points;  ///< in the assembly's unit
};

/// A part in the picture, for what is written beside it.
struct DrawnPart {
  std::string name;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< the middle of its axis
  std::vector<double> diameters;  ///< of its two ends, or of a ball; across ellipses' axes
};

/// A drawing of a solid as it is seen from afar.
struct Drawing {
  std::string source;
  Unit unit = Unit::millimetre;
  View view;
  double error =
      0;  ///< how far lines may be from what they stand for, contours and the mesh's edges
  std::vector<DrawnLine> lines;
  std::vector<DrawnPart> parts = {};  ///< in the order of the assembly
};

/// The visible outline of `built`, which `build` made of the assembly: contours of its smooth
/// surfaces, and the edges in which parts meet other than tangentially. What is visible is decided
/// with respect to the mesh, within a few of its errors. O(lines log triangles + what covers them).
/// Throws Error{invalid_argument} for a view that is not finite.
[[nodiscard]] Drawing draw(const Assembly& assembly, const Built& built,
                           const DrawingOptions& options);

/// The cosine of the largest angle between a triangle's normal and those at its corners: 75.5
/// degrees, more than the 60 degrees of a pipe that has three segments.
inline constexpr double kLeastNormalCosine = 0.25;

/// The outward unit normals of the smooth surfaces that `mesh` approximates, so that it can be
/// shaded as what it stands for. `mesh` is `built.solid` (made of the assembly by `build`),
/// possibly rounded, simplified or meshed anew, in the solid's coordinates and with its labels;
/// `moved` is how far that took points off it.
///
/// A corner's normal is that of the surface whose patch the triangle belongs to, at the surface's
/// point nearest to the corner: found by the exact equation of the disc through it, evaluated in
/// closed form, and right to the rounding of binary32 for points on the surface; in doubles, which
/// nothing encloses. Corners of a point have one normal for each patch around it, bitwise the same,
/// and one for all of those patches that are known to be tangent there: pieces of a part, parts
/// that share a ring, fillets and what they are between, hubs and their arms, if the surfaces' own
/// normals differ by at most one degree. All others are creases: edges of unions, rims of discs,
/// joints with an angle.
///
/// Two things are certain of every corner, whatever the mesh and the surfaces: the normal is a unit
/// vector to binary32 rounding, and its angle to the normal of the triangle, as far as doubles tell
/// that it has any area, has at least the cosine kLeastNormalCosine. Where the surface's normal
/// would be further off, where the corner is further from all surfaces that its label names than
/// `moved` and four times the tolerance or the mesh's error bound, and where the label names none,
/// it is the triangle's own.
///
/// The same for any number of threads. O(triangles), times the pieces of a part in the worst case;
/// a million triangles take about half a second of two cores. Throws as `smooth_region` and
/// `validate`, and Error{invalid_argument} for a `moved` that is negative or not finite.
[[nodiscard]] CornerNormals smooth_normals(const Assembly& assembly, const Built& built,
                                           const TriMesh& mesh, double moved = 0);

/// The same of meshes that together are what was built, one after the other: the solid need not be
/// at hand any more, but for the names of the labels that it has.
[[nodiscard]] std::function<CornerNormals(const TriMesh& mesh, double moved)> smooth_normals(
    const Assembly& assembly, const Built& built, const std::set<std::string>& names);

}  // namespace dupin
