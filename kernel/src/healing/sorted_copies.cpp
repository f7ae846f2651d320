#include "healing/sorted_copies.h"

#include <algorithm>
#include <tuple>

#include "support/sequences.h"

namespace dupin::healing {

std::vector<Copy> sorted_copies(std::span<const Triangle> triangles) {
  return sorted_copies(triangles, support::numbers_below(triangles.size()));
}

std::vector<Copy> sorted_copies(std::span<const Triangle> triangles,
                                std::span<const std::uint32_t> faces) {
  std::vector<Copy> copies;
  copies.reserve(faces.size());
  for (const std::uint32_t face : faces) {
    Triangle corners = triangles[face];
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    const bool is_odd = corners[1] > corners[2];
    std::ranges::sort(corners);
    copies.push_back({corners, is_odd, face});
  }
  std::ranges::sort(copies, {}, [](const Copy& copy) {
    return std::tuple(copy.corners, copy.is_odd, copy.face);
  });
  return copies;
}

}  // namespace dupin::healing
