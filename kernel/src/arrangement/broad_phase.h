#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "arrangement/input.h"
#include "support/progress_stage.h"

namespace dupin::arrangement {

struct TrianglePair {
  std::uint32_t first, second;
  friend bool operator==(const TrianglePair&, const TrianglePair&) = default;
  /// As one number: these are sorted in great numbers.
  friend auto operator<=>(const TrianglePair& a, const TrianglePair& b) {
    return (std::uint64_t{a.first} << 32 | a.second) <=> (std::uint64_t{b.first} << 32 | b.second);
  }
};

/// Stage 2: for each pair of operands in question, pairs of triangles whose boxes overlap, every
/// pair that meets among them, but of one operand those that have a corner in common and no more;
/// merged triangles left out. In a fixed order. `memory_limit` is in bytes, 0 for the machine's:
/// what is beyond it is counted only, and Error{limit_exceeded} thrown.
[[nodiscard]] std::vector<TrianglePair> broad_phase(const ArrangementInput& input,
                                                    const support::ProgressStage& stage,
                                                    std::uint64_t memory_limit = 0);

}  // namespace dupin::arrangement
