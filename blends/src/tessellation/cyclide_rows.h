#pragma once

#include "cyclide/arc_bounds.h"
#include "dupin/blends/pe_arc.h"
#include "tessellation/swept_mesh.h"

namespace dupin::tessellation {

/// A march along the piece by fractions of its tangential length; `around` is the angle of a
/// segment.
[[nodiscard]] BandStepper march_of(const PeArc& arc, double around);

/// The largest radius of the piece's circles, nearly.
[[nodiscard]] double largest_circle(const PeArc& arc);

/// How far a computed and snapped point may lie from the piece's surface.
[[nodiscard]] double point_error(const PeArc& arc, double grid);

/// The circle, with the frame that the symmetry plane carries along, at a fraction of the piece's
/// tangential length; `plane_normal` is frame(arc).second.
[[nodiscard]] Row row_at(const PeArc& arc, double fraction, const Vec3& plane_normal);

}  // namespace dupin::tessellation
