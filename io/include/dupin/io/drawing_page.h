#pragma once

#include <map>
#include <string>

#include "dupin/blends/drawing.h"
#include "dupin/io/drawing_svg.h"
#include "dupin/kernel/solid.h"

namespace dupin {

/// Whether drawings can be written as PDF and PNG: it takes a build with cairo.
[[nodiscard]] bool can_draw_pages();

struct PictureOptions {
  double dots_per_inch = 150;  ///< positive
  /// What is drawn in colours behind the lines, with light and shade: that of which `drawing` is.
  /// None: lines alone.
  const Solid* shaded = nullptr;
  std::map<std::string, std::string> colours = {};  ///< of parts, as parse_document has them
};

/// The drawing of drawing_svg as PDF 1.5, lines and letters as such. The same bytes for the same
/// drawing and fonts. Throws Error{invalid_argument} without cairo.
[[nodiscard]] std::string drawing_pdf(const Drawing& drawing, const DrawingScale& scale,
                                      const SheetOptions& options = {});

/// The same as PNG, on white. Throws Error{limit_exceeded} for more than 100 million pixels,
/// Error{invalid_argument} for a number of dots that is not positive and finite.
[[nodiscard]] std::string drawing_png(const Drawing& drawing, const DrawingScale& scale,
                                      const SheetOptions& options = {},
                                      const PictureOptions& picture = {});

}  // namespace dupin
