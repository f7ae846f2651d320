#pragma once

#include <optional>

#include "dupin/blends/end.h"
#include "dupin/blends/ringed_surface.h"
#include "dupin/kernel/enclosure.h"

namespace dupin {

/// How smoothly a ringed surface runs into the cylinder or cone that its stored end ring belongs
/// to.
struct Tangency {
  /// The largest angle around the end circle, in radians, between the surface along the spine and
  /// the neighbour's wall of half angle atan(slope): max |atan2(R', |y'|(1 - kappa R cos theta)) -
  /// half angle| [MS06]. Exactly 0 for a radius law of slope 0 against a cylinder, unless kappa R
  /// >= 1, where the surface has folded.
  Enclosure deviation;
  /// Between the spine's velocity and the stored normal, in radians; exactly 0 if they are
  /// parallel. The walls meet at an angle of at most the sum of both.
  Enclosure axis_angle;
  Enclosure curvature_times_radius;  ///< kappa R at the end

  [[nodiscard]] bool exact() const { return deviation.upper == 0 && axis_angle.upper == 0; }
};

/// Upper bounds at an end of a piece, as a certificate claims them.
struct TangencyClaim {
  /// Tangency::deviation, in radians; none for elliptic tubes and general ringed surfaces.
  std::optional<double> deviation;
  double axis_angle = 0;  ///< between the disc's normal and the ring's, in radians
  double offset = 0;      ///< of the disc's centre from the ring's, plus that of the radii
  /// Of ringed surfaces, their curvature along the parameter lines: what it jumps by where a
  /// cylinder or cone goes on (curvature_jump_bound).
  std::optional<double> curvature = {};
};

/// Certified: computed from the stored numbers in intervals of high precision, rounded outward.
/// Throws Error{irregular_surface} where the spine stands still.
[[nodiscard]] Tangency tangency_at_end(const RingedSurface& surface, End end);

/// An upper bound, by interval arithmetic on the stored numbers, of the normal curvature that the
/// surface has along its parameter lines at an end ring. The cylinder or cone beyond the ring has
/// none in its rulings' directions; so where the tangent planes agree, this is the jump of
/// curvature [MS06].
///
/// Throws Error{irregular_surface} where the spine stops or the surface folds at that end.
[[nodiscard]] double curvature_jump_bound(const RingedSurface& surface, End end);

}  // namespace dupin
