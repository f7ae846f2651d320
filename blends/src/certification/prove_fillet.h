#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dupin/blends/certificate.h"

namespace dupin::certification {

/// The mesh of a loop: rows at these angles, in [0, 2 pi), each divided into so many segments.
struct LoopMesh {
  std::vector<double> rows;
  std::uint32_t segments = 1;
  double grid = 0;
};

struct LoopGoals {
  std::optional<double> margin;  ///< none: nearly the largest that holds
  std::size_t pairs = 0;         ///< that the loop may be divided into
  double tolerance = 0;          ///< of the document
};

/// Claims about a loop of a fillet, found by halving until the checker's bounds hold; what it costs
/// is limited, and what is not found then is undecided. Contact is claimed nearly within a factor
/// of four of the least bounds that hold.
///
/// Throws Error{invalid_argument} if the balls are further from their quadrics than the tolerance.
[[nodiscard]] LoopClaims prove_loop(const CanalFillet& loop, const LoopMesh& mesh,
                                    const LoopGoals& goals);

}  // namespace dupin::certification
