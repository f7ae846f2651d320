#pragma once

#include <array>
#include <variant>
#include <vector>

#include "dupin/blends/canal_patch.h"
#include "dupin/blends/pe_arc.h"
#include "dupin/kernel/ring.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// Balls of one radius on two cylinders of which the thinner passes through the thicker: the
/// parameter is the angle around the thinner one. Their centres are
/// origin + x along + side y across + z up, with z = d sin - height,
/// y = sqrt((below + d (1 - sin)) (above + d (1 + sin))), x = (d cos + side y cosine) / sine.
struct RollingThrough {
  Vec3 origin = Vec3::Zero();  ///< of the thicker cylinder's axis, nearest to the other axis
  /// Orthonormal: the thicker axis, what the thinner axis has across it, and their product.
  Vec3 along = Vec3::UnitX(), across = Vec3::UnitY(), up = Vec3::UnitZ();
  double cosine = 0, sine = 1;  ///< of the angle between the axes, sine > 0
  double distance = 1;          ///< d: of the centres from the thinner axis
  double height = 0;            ///< of the thicker axis over the thinner one
  double below = 0, above = 0;  ///< difference of the radii plus and minus the height, >= 0
  double side = 1;              ///< 1 or -1
  double radius = 1;
};

/// The same on two cylinders of which neither passes through the other. The centres are
/// origin + x along + y across + z up, with z = w sin^2 - d1, y = sqrt(w) sin sqrt(first + w
/// cos^2), x = (sqrt(w) cos sqrt(second + w sin^2) + y cosine) / sine, w = d1 + d2 - height.
struct RollingPartly {
  Vec3 origin = Vec3::Zero();  ///< of the upper axis, nearest to the other axis
  Vec3 along = Vec3::UnitX(), across = Vec3::UnitY(), up = Vec3::UnitZ();
  double cosine = 0, sine = 1;
  double distance = 1;           ///< d1: of the centres from the upper axis
  double overlap = 1;            ///< w > 0
  double first = 1, second = 1;  ///< d1 - d2 + height and d2 - d1 + height, > 0
  double radius = 1;
};

/// Balls that touch two cylinders or cones, one loop of them; the parameter has the period 2 pi.
/// Value type: what is stored defines the balls.
struct CanalFillet {
  std::array<Ring, 2> quadrics;  ///< as they were given, in that order
  std::variant<RollingThrough, RollingPartly> motion;
};

/// The ball and its motion at a parameter. At a corner (`corners`) the derivatives are one-sided:
/// those of the side on which the rounded parameter lies.
[[nodiscard]] MovingBall ball(const CanalFillet& fillet, double parameter);

/// An upper bound of |m''| over a stretch, by interval arithmetic; infinite where none is found. A
/// corner may be an end of the stretch, not inside of it.
[[nodiscard]] double acceleration_bound(const CanalFillet& fillet, double from, double to);

/// The parameters in (-pi, pi] where the loop has a corner: the feet coincide there, where one
/// cylinder touches the other from inside (at one place), or both are equally thick and their axes
/// meet (at pi/2 and -pi/2). Both loops have their corners in the same places.
[[nodiscard]] std::vector<double> corners(const CanalFillet& fillet);

/// The fillets of a ball of constant radius between two quadrics, which it touches from outside
/// (mathematics B.7). Two where one quadric passes through the other, or touches it from inside, or
/// both are equally thick and meet: first the one on the side to which the ring normal of the
/// quadric that passes points; the quadric that passes through is the thinner one, of equal ones
/// the second. One where neither passes through the other.
///
/// The rounded distance of axes is taken for tangency from inside where it is that within rounding.
///
/// Throws Error{invalid_argument} for invalid or elliptic rings and radii that are not positive;
/// Error{irregular_surface} where the ball has no closed loop around an edge of both: the axes are
/// parallel, or the quadrics do not meet.
[[nodiscard]] std::vector<CanalFillet> rolling_ball_fillets(const std::array<Ring, 2>& quadrics,
                                                            double radius);

}  // namespace dupin
