#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/io/drawing_svg.h"

namespace dupin::drawings {

enum class Pen { contour, edge, hidden, center, thin, arrow };

/// As a class of SVG: "contour", ...
[[nodiscard]] std::string_view name(Pen pen);

/// Millimetres, of lines seen and of all others; solids ("arrow") have no line.
constexpr double kWide = 0.35, kNarrow = 0.18;
/// Height of capitals, of ISO 3098, what a font calls its size, and the width of a white pen round
/// letters.
constexpr double kTextHeight = 2.5, kFontSize = 3.5, kTextMargin = 0.8;

/// The dashes and gaps of a pen, in millimetres; none: a continuous line.
[[nodiscard]] std::vector<double> dashes(Pen pen);

struct PaperLine {
  Pen pen = Pen::contour;
  std::string part;  ///< empty: of the drawing as a whole
  std::vector<Eigen::Vector2d> points;
  bool is_closed = false;  ///< from the last point to the first
};

/// A line of text that begins at its base line's left end, or is centred about it.
struct PaperText {
  std::string text;
  Eigen::Vector2d at;
  bool is_centered = false, is_upright = false;  ///< upright: read from the right side
};

/// A drawing in millimetres on paper, x to the right and y downwards.
struct PaperSheet {
  std::string title;
  Eigen::Vector2d size = Eigen::Vector2d::Zero();
  std::vector<PaperLine> lines;  ///< in the order in which they are drawn
  std::vector<PaperText> texts;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< of the picture, on paper
  double factor = 1;  ///< millimetres on paper for a unit of the picture
};

/// The largest of ISO 5455 at which a length is not less than `real_by_paper` times that on paper.
[[nodiscard]] DrawingScale usual_scale(double real_by_paper);

[[nodiscard]] PaperSheet paper_sheet(const Drawing& drawing, const DrawingScale& scale,
                                     const SheetOptions& options);

}  // namespace dupin::drawings
