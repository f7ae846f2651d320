#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/constraints.h"
#include "arrangement/input.h"
#include "support/progress_stage.h"

namespace dupin::arrangement {

/// The sub-triangles of the retriangulated faces. Those of one region have no intersection between
/// them.
struct Subdivision {
  struct SubTriangle {
    Triangle corners;  ///< oriented as the support of the region's first triangle
    std::uint32_t region;
    std::uint8_t open;  ///< bit i: the edge opposite to corner i bounds the region
  };
  struct Region {
    std::uint32_t first_cover, end_cover;  ///< the triangles that cover it
    std::uint32_t support;                 ///< a triangle whose plane and orientation it has
  };
  support::BulkVector<SubTriangle> triangles;
  support::BulkVector<Region> regions;
  std::vector<SignedTriangle> covers;

  [[nodiscard]] std::span<const SignedTriangle> cover(std::uint32_t region) const {
    return std::span(covers).subspan(regions[region].first_cover,
                                     regions[region].end_cover - regions[region].first_cover);
  }
};

/// Stage 5: triangulates every face with the points and segments on it. Adds the points where
/// segments cross to the input. Needs UpwardRounding.
[[nodiscard]] Subdivision retriangulate(ArrangementInput& input, const BooleanRule& rule,
                                        Constraints& constraints,
                                        const support::ProgressStage& stage);

}  // namespace dupin::arrangement
