#pragma once

#include <string>

#include "dupin/blends/drawing.h"

namespace dupin {

/// Lengths on paper by lengths of the thing drawn: 1:50 is {1, 50}.
struct DrawingScale {
  double paper = 1, real = 1;
};

/// What is written on the sheet besides the lines.
struct SheetOptions {
  bool names = false;  ///< of the parts, with leaders
  /// The parts' diameters and, of a view along an axis, the overall width and height. To as many
  /// digits as the drawing's error leaves, in millimetres or with the unit.
  bool dimensions = false;
};

/// "1:50".
[[nodiscard]] std::string to_string(const DrawingScale& scale);

/// Of "1:50" or "2:1". Throws Error{invalid_argument} for other texts and numbers that are not
/// positive.
[[nodiscard]] DrawingScale drawing_scale(const std::string& text);

/// The largest of ISO 5455, 1, 2 or 5 times a power of ten to 1 or 1 to that, at which the drawing
/// fits on a sheet of A3 with 10 mm around.
[[nodiscard]] DrawingScale fitting_scale(const Drawing& drawing);

/// How large the drawing is on paper, in millimetres, with 5 mm around; {10, 10} of one without
/// lines.
[[nodiscard]] Eigen::Vector2d size_on_paper(const Drawing& drawing, const DrawingScale& scale,
                                            const SheetOptions& options = {});

/// SVG 1.1 of that size, its user unit a millimetre on paper, numbers to a thousandth of one. Lines
/// of a part are a group, whose title is the part's name; `class` is contour, edge, hidden or
/// center. Visible lines are 0.35 mm wide, others 0.18 mm; hidden ones are dashed, axes
/// dash-dotted (ISO 128).
[[nodiscard]] std::string drawing_svg(const Drawing& drawing, const DrawingScale& scale,
                                      const SheetOptions& options = {});

/// What was written to `file`: `{"file", "unit", "scale", "size": [width, height] in mm on paper,
/// "direction", "up", "error", "lines": {"contour", "edge", "hidden", "center"}}`, the latter
/// numbers of lines.
[[nodiscard]] std::string drawing_report_json(const Drawing& drawing, const DrawingScale& scale,
                                              const std::string& file,
                                              const SheetOptions& options = {});

}  // namespace dupin
