#pragma once

#include <vector>

#include "drawing/sheet.h"

namespace dupin::drawing {

/// A point of a sheet whose normal is at right angles to a direction, and the surface's curvature
/// along that: positive where it curves away from the normal, as a ball does.
struct ZeroPoint {
  Vec3 position, normal;
  double curvature = 0;
};

/// Points along a curve, in order.
using ZeroLine = std::vector<ZeroPoint>;

/// Where the sheet's normals are at right angles to a unit vector, as polylines whose segments are
/// within `tolerance` of it: traced through the sheet's cells from edge to edge and halved until
/// they are. Loops within one cell are not found. Where the normals of a whole region are at right
/// angles, as of a cylinder seen along its axis, nothing is; a side of the sheet is, where they are
/// so there alone.
[[nodiscard]] std::vector<ZeroLine> zero_lines(const Sheet& sheet, const Vec3& direction,
                                               double tolerance);

}  // namespace dupin::drawing
