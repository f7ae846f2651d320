#include "dupin/kernel/connected_components.h"

#include "support/blocks.h"
#include "support/disjoint_sets.h"

namespace dupin {

std::vector<std::uint32_t> connected_components(std::span<const Triangle> triangles,
                                                std::size_t point_count) {
  support::DisjointSets components(point_count);
  support::for_each_block(triangles.size(), [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const auto& [a, b, c] = triangles[i];
      components.unite(a, b);
      components.unite(a, c);
    }
  });
  return components.representatives();
}

}  // namespace dupin
