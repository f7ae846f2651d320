#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/vec.h"

namespace dupin::detail {

/// The same for points with the same coordinates (0.0 and -0.0 are the same).
[[nodiscard]] std::uint64_t hash_of(const Vec3& point);

/// For each point the index of the first one with the same coordinates (0.0 and -0.0 are the
/// same). The points are finite. O(n).
[[nodiscard]] std::vector<std::uint32_t> first_identical(std::span<const Vec3> points);

}  // namespace dupin::detail
