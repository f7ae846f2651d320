#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

namespace dupin::districts {

using TouchingPairs = std::vector<std::array<std::uint32_t, 2>>;

/// The pairs of boxes that touch, the lower number first, in any order; none where more than a few
/// per box would have to be compared. Empty boxes touch nothing. Bounds are numbers. O(n log n).
[[nodiscard]] std::optional<TouchingPairs> touching_pairs(
    std::span<const Eigen::AlignedBox3d> boxes);

}  // namespace dupin::districts
