#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "assembly/districts/dividing_rings.h"
#include "assembly/districts/pipe_stretches.h"

namespace dupin::assembly {

/// A district some pipes of which are in stretches; other parts, fillets and junctions keep their
/// places and their order.
struct StretchedDistrict {
  PipeStretches stretches;
  DistrictParts members;
  PieceOf common;

  [[nodiscard]] Divisible divisible() const { return {stretches.resolved, members, common}; }
};

/// Cuts are those of parts of the district. O(parts of the assembly).
[[nodiscard]] StretchedDistrict stretched(const Divisible& whole, const PipeCuts& cuts);

/// Fewer cuts, and of what is in boxes between these the first of those that were there before.
struct FewerCuts {
  PipeCuts cuts;
  std::vector<std::uint32_t> boxes;
};

/// Those of `cuts`, which the district has, that are between boxes of different groups.
[[nodiscard]] FewerCuts cuts_between(const StretchedDistrict& district, const PipeCuts& cuts,
                                     const std::function<std::uint32_t(std::uint32_t)>& group_of);

}  // namespace dupin::assembly
