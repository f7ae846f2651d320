#include "dupin/kernel/connected_components.h"

#include "support/disjoint_sets.h"

namespace dupin {

std::vector<std::uint32_t> connected_components(std::span<const Triangle> triangles,
                                                std::size_t point_count) {
  support::DisjointSets components(point_count);
  for (const auto& [a, b, c] : triangles) {
    components.unite(a, b);
    components.unite(a, c);
  }
  return components.representatives();
}

}  // namespace dupin
