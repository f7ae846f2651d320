#include "tessellation/convex_fill.h"

namespace dupin::tessellation {

void fill(std::uint32_t first, std::uint32_t last, std::vector<Triangle>& triangles) {
  if (last - first < 2) {
    return;
  }
  const std::uint32_t middle = (first + last) / 2;
  triangles.push_back({first, middle, last});
  fill(first, middle, triangles);
  fill(middle, last, triangles);
}

}  // namespace dupin::tessellation
