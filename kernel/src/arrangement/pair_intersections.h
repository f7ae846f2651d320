#pragma once

#include <span>
#include <vector>

#include "arrangement/broad_phase.h"
#include "arrangement/input.h"
#include "arrangement/triangle_intersection.h"
#include "support/progress_stage.h"

namespace dupin::arrangement {

/// What the triangles of all candidates have in common, in their order.
struct Intersections {
  std::vector<TriangleIntersection> found;
  /// At edges inside of sheets that cross each other, the points of which are left out of `found`:
  /// the triangles on both sides; ascending.
  std::vector<TrianglePair> crossed_sheets;
};

/// Stage 3 for all pairs.
[[nodiscard]] Intersections find_intersections(const ArrangementInput& input,
                                               std::span<const TrianglePair> candidates,
                                               const support::ProgressStage& stage);

}  // namespace dupin::arrangement
