#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace dupin::healing {

/// A count that is not known: of faces that hang together, negative if the other way round.
struct UnknownCount {
  std::size_t size = 0;       ///< how many faces
  int least = 0, most = 0;    ///< of the count's size; the first 0 or 1
  std::int64_t majority = 0;  ///< of faces that are the one way round over those the other way
  bool may_vanish = false;  ///< a sheet, as often the one way as the other: rather 0, if it may be
};

/// Adds up to zero.
struct CountEquation {
  struct Term {
    std::uint32_t unknown;
    int factor;
  };
  std::vector<Term> terms;  ///< of different unknowns, no factor zero
};

/// Gives each unknown a count in its range, such that the equations hold if that is found: large
/// ones go by their majority, others by what the equations leave. Unknowns that are there once and
/// are in the same equations, as walls are that end along the same edges, are told apart in the
/// end: what they add up to is one unknown. With `trusting`, all that are there once go by their
/// majority, whatever the equations say.
///
/// O(n log n).
[[nodiscard]] std::vector<int> solved_counts(std::span<const UnknownCount> unknowns,
                                             std::span<const CountEquation> equations,
                                             bool trusting);

}  // namespace dupin::healing
