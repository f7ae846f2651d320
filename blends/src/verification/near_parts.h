#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "verification/solid.h"

namespace dupin::verification {

/// Indices of two parts, the lower first.
using PartPair = std::array<std::uint32_t, 2>;

/// The pairs, ascending, of parts whose axis-parallel boxes are nearer than `distance` along every
/// axis: two parts that are no such pair are at least so far from each other. Of a part that
/// nothing is known of there is no box, and it is near all. O(n log n) for parts that are
/// scattered. Throws as spend().
[[nodiscard]] std::vector<PartPair> pairs_nearer_than(double distance,
                                                      const std::vector<Solid>& solids);

}  // namespace dupin::verification
