#pragma once

#include "dupin/blends/ringed_surface.h"

namespace dupin {

/// Upper bounds, by interval arithmetic on the stored numbers, of how a surface's end departs from
/// the cylinder or cone that its ring's slope stands for.
struct EndContact {
  double tangency_angle = 0;  ///< largest angle between the tangent planes along the ring, radians
  /// Largest normal curvature across the ring; the cylinder or cone has none in its direction, so
  /// where the tangent planes agree this is the jump of curvature.
  double curvature_jump = 0;
};

struct EndContacts {
  EndContact start, end;
};

/// For contact of cylinders and cones [MS06] section 3. Throws Error{irregular_surface} where the
/// spine stops or the surface folds at an end.
[[nodiscard]] EndContacts end_contacts(const RingedSurface& surface);

}  // namespace dupin
