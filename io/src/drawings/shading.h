#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "drawings/paper_sheet.h"
#include "dupin/kernel/solid.h"
#include "dupin/kernel/view.h"

namespace dupin::drawings {

/// Rows of pixels from above, each 0xAARRGGBB; transparent where there is nothing.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;
};

/// The solid as a viewer sees it, on a sheet of `width` times `height` pixels: every part in the
/// colour that `colours` has for it, by its name, as "#rrggbb", or in one of its own, lit from the
/// upper left, its triangles' normals averaged where they differ little. Of each pixel three by
/// three points are looked at. O(triangles + what they cover). Always the same picture.
[[nodiscard]] Picture shaded(const Solid& solid, const std::map<std::string, std::string>& colours,
                             const View& view, const PaperSheet& sheet,
                             double pixels_per_millimetre);

}  // namespace dupin::drawings
