#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

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

}  // namespace dupin::shading
