#pragma once

#include "cyclide/arc_bounds.h"
#include "dupin/blends/pe_arc.h"
#include "tessellation/band_stepper.h"

namespace dupin::tessellation {

/// A march along the piece by fractions of its tangential length; `around` is the angle of a
/// segment.
[[nodiscard]] BandStepper march_of(const PeArc& arc, double around);

/// The largest radius of the piece's circles, nearly.
[[nodiscard]] double largest_circle(const PeArc& arc);

/// How far a computed and snapped point may lie from the piece's surface.
[[nodiscard]] double point_error(const PeArc& arc, double grid);

/// A row of points: a circle with the frame that the symmetry plane of its piece carries along, and
/// the angle in it of the polygon's first corner.
struct Row {
  Ring circle;
  Vec3 first, second;
  double angle = 0;

  [[nodiscard]] Vec3 direction(double a) const;
};

/// The row at a fraction of the piece's tangential length, `plane_normal` being frame(arc).second.
[[nodiscard]] Row row_at(const PeArc& arc, double fraction, const Vec3& plane_normal);

}  // namespace dupin::tessellation
