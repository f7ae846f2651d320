#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dupin/blends/resolve.h"
#include "shading/patch.h"

namespace dupin::shading {

/// Patches by their numbers, and what they have to do with each other.
struct PatchTable {
  std::vector<Patch> patches;
  /// What a name may stand for, in ascending order.
  std::map<std::string, std::vector<std::uint32_t>> of_name;
  /// Pairs that may be tangent where they meet, the lesser number first: pieces that follow each
  /// other, in a part or in two that share a ring, those of a chain and the balls between them,
  /// fillets and what they are between, hubs and their arms, heads and the discs of their tips.
  std::set<std::pair<std::uint32_t, std::uint32_t>> neighbours;

  [[nodiscard]] bool are_neighbours(std::uint32_t a, std::uint32_t b) const {
    return neighbours.contains(std::minmax(a, b));
  }
};

/// Adds what the parts, fillets and hubs of an assembly are, with the discs of its ends and the
/// rims of its walls, under the names that `build` gives their triangles, or those that `renamed`
/// has for these. O(n log n).
void add_patches(const ResolvedAssembly& assembly,
                 const std::map<std::string, std::string>& renamed, PatchTable& table);

}  // namespace dupin::shading
