#pragma once

#include <utility>
#include <vector>

#include "network/piping_stretches.h"

namespace dupin::network {

/// A chain and what becomes of it.
struct PlannedChain {
  const Chain* chain = nullptr;
  ChainPlan* plan = nullptr;
};

/// The fillets between the runs and branches of fittings, each with its component's position, of
/// the radius asked for; of those that are to be chosen, a quarter of the branch's radius, or the
/// largest of some smaller ones that fits. Where a fitting is too short for the ball's way it takes
/// from pipes of the same radius beside it. What does not fit is refused, or noted if it was to be
/// chosen. Throws as assembly_of(PipingLine).
[[nodiscard]] std::vector<std::pair<Part, std::size_t>> fillets(
    const PipingLine& line, const PipingOptions& options, const PipingSpans& spans,
    const std::vector<PlannedChain>& chains, LineNotes& notes);

}  // namespace dupin::network
