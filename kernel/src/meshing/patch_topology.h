#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::meshing {

/// Where a mesh of a region ends: points in order, and on how many sides of them it is.
struct BorderChain {
  std::vector<std::uint32_t> points;
  std::uint32_t sides = 1;
};

/// Whether triangles have all edges of the chains, on as many sides of them, and else none but such
/// as two of them have. If so, those that hang together are turned to agree with each other, and so
/// that the sum of `outward`, of each triangle as it is given, is not negative.
[[nodiscard]] bool turn_outward(std::vector<Triangle>& triangles, std::span<const double> outward,
                                std::span<const BorderChain> chains);

}  // namespace dupin::meshing
