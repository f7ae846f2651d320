#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "dupin/blends/assembly.h"
#include "dupin/blends/build.h"
#include "dupin/kernel/view.h"

namespace dupin {

struct DrawingOptions {
  View view;
  bool hidden = false;  ///< whether lines are drawn that the solid hides
};

enum class LineKind {
  contour,  ///< of a smooth surface
  edge,     ///< where two surfaces meet and the solid turns
};

/// A line in the picture, x to the right and y upwards.
struct DrawnLine {
  std::string part;  ///< what it belongs to: the part of the surface, or one of two that meet
  LineKind kind = LineKind::contour;
  bool hidden = false;
  std::vector<Eigen::Vector2d> points;  ///< in the assembly's unit
};

/// A drawing of a solid as it is seen from afar.
struct Drawing {
  std::string source;
  Unit unit = Unit::millimetre;
  View view;
  double error =
      0;  ///< how far lines may be from what they stand for, contours and the mesh's edges
  std::vector<DrawnLine> lines;
};

/// The visible outline of `built`, which `build` made of the assembly: contours of its smooth
/// surfaces, and the edges in which parts meet other than tangentially. What is visible is decided
/// with respect to the mesh, within a few of its errors. O(lines log triangles + what covers them).
[[nodiscard]] Drawing draw(const Assembly& assembly, const Built& built,
                           const DrawingOptions& options);

}  // namespace dupin
