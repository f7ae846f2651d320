#pragma once

#include "drawings/paper_sheet.h"

namespace dupin::drawings {

/// Adds names and diameters of the parts, each with a leader to the middle of the part, where they
/// cover as little as can be found.
void add_notes(const Drawing& drawing, const SheetOptions& options, PaperSheet& sheet);

/// Adds the overall width and height, below and to the right, of a view along an axis.
void add_extents(const Drawing& drawing, PaperSheet& sheet);

/// A length of the drawing, with as many digits as its error leaves.
[[nodiscard]] std::string length_text(const Drawing& drawing, double length);

}  // namespace dupin::drawings
