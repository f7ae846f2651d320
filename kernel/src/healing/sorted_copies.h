#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::healing {

/// A triangle by its corners in ascending order. Copies of each other are those of the same.
struct Copy {
  Triangle corners;
  bool is_odd;  ///< it runs the other way round
  std::uint32_t face;
};

/// Copies side by side: those of even orientation first, and in the order of faces. O(n log n).
[[nodiscard]] std::vector<Copy> sorted_copies(std::span<const Triangle> triangles);
/// The same of some of them.
[[nodiscard]] std::vector<Copy> sorted_copies(std::span<const Triangle> triangles,
                                              std::span<const std::uint32_t> faces);

}  // namespace dupin::healing
