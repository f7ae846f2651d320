#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "dupin/blends/part_surface.h"
#include "dupin/blends/pe_arc.h"
#include "dupin/blends/resolve.h"

// This folder: what an assembly looks like from afar. The smooth surfaces, as sheets over
// rectangles of parameters (sheet.h), have contours, where their normals are at right angles to the
// direction of view (zero_lines.h); the solid's mesh has creases, and hides some of both
// (dupin/kernel/hidden_lines.h). drawing.cpp puts them together.

namespace dupin::drawing {

/// A point and its outward unit normal.
using SheetPoint = ArcPoint;

/// A regular piece of a surface over t and v in [0, 1].
struct Sheet {
  std::function<SheetPoint(double t, double v)> at;
  std::uint32_t rows = 1, columns = 1;  ///< cells in which normals turn little, along t and v
  bool closed = true;                   ///< v = 1 is v = 0
};

/// Refers to the piece.
[[nodiscard]] Sheet sheet_of(const Piece& piece);

/// One for each piece. The sheets refer to the chain.
[[nodiscard]] std::vector<Sheet> sheets_of(const Chain& chain);

/// The loops between the pipes, seen from outside of the solid. The sheets refer to the fillet.
[[nodiscard]] std::vector<Sheet> sheets_of(const Fillet& fillet);

}  // namespace dupin::drawing
