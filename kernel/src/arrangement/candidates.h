#pragma once

#include <cstdint>
#include <vector>

#include "scene.h"
#include "stage.h"

namespace dupin::detail {

struct TrianglePair {
  std::uint32_t first, second;
  friend auto operator<=>(const TrianglePair&, const TrianglePair&) = default;
};

/// Stage 2: for each pair of operands in question, pairs of triangles whose boxes overlap, every
/// pair that meets among them; merged triangles left out. In a fixed order.
[[nodiscard]] std::vector<TrianglePair> find_candidates(const Scene& scene, const Stage& stage);

}  // namespace dupin::detail
