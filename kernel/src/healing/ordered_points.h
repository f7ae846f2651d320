#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::healing {

/// For each point its place in the order of coordinates, which does not depend on how points are
/// numbered where they all differ.
[[nodiscard]] std::vector<std::uint32_t> places_by_coordinates(std::span<const Vec3> points);

}  // namespace dupin::healing
