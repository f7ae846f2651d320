#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "verification/claims/loop_clearance.h"
#include "verification/solid.h"

namespace dupin::verification {

/// Indices of two parts, the lower first.
using PartPair = std::array<std::uint32_t, 2>;

/// Along which boxes lie; none: the axes of coordinates.
using BoxAxes = std::optional<Directions>;

/// The pairs, ascending, of parts whose boxes along the axes are nearer than `distance` along every
/// one: two parts that are no such pair are at least so far from each other. Of a part that
/// nothing is known of there is no box, and it is near all. O(n log n) for parts that are
/// scattered. Throws as spend().
[[nodiscard]] std::vector<PartPair> pairs_nearer_than(double distance, const BoxAxes& axes,
                                                      const std::vector<Solid>& solids);

/// Of surfaces, which are parts and after them loops of fillets: the pairs with a loop, in the
/// order of `place_of`. The box of a loop is that of its arcs' hulls.
[[nodiscard]] std::vector<PartPair> loop_pairs_nearer_than(double distance, const BoxAxes& axes,
                                                           const std::vector<Solid>& solids,
                                                           const std::vector<LoopArcs>& loops);

/// Where a pair with a loop stands among those of all surfaces: of the first loop with every part,
/// then with every later loop; then of the second one, and so on.
using Place = std::array<std::size_t, 3>;
[[nodiscard]] inline Place place_of(const PartPair& pair, std::size_t parts) {
  const auto [first, second] = pair;
  return first < parts ? Place{second - parts, 0, first} : Place{first - parts, 1, second};
}

}  // namespace dupin::verification
