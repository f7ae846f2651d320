#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "arrangement/constraints.h"
#include "arrangement/input.h"
#include "support/progress_stage.h"

namespace dupin::arrangement {

/// What the cut faces fall into: regions, each with sub-triangles, between which there is no
/// intersection, or with an outline.
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
  /// A region that is a simple polygon, counter-clockwise as seen from the front of its support;
  /// it is triangulated if it is kept.
  struct Outline {
    std::uint32_t region, begin, end;  ///< into outline_corners
  };
  struct OutlineCorner {
    PointId point;
    PointId apex;        ///< on the region's side of the line from the corner to the next one
    std::uint8_t sides;  ///< see ConstrainedTriangulation::add
  };
  support::BulkVector<SubTriangle> triangles;
  support::BulkVector<Region> regions;
  support::BulkVector<Outline> outlines;  ///< of regions without triangles
  support::BulkVector<OutlineCorner> outline_corners;
  std::vector<SignedTriangle> covers;
  std::vector<std::uint8_t> touched;  ///< per triangle of the input: part of a face that was cut

  [[nodiscard]] std::span<const SignedTriangle> cover(std::uint32_t region) const {
    return std::span(covers).subspan(regions[region].first_cover,
                                     regions[region].end_cover - regions[region].first_cover);
  }
};

/// Stage 5: divides every face by the points and segments on it. Adds the points where segments
/// cross to the input. Needs UpwardRounding.
[[nodiscard]] Subdivision retriangulate(ArrangementInput& input, const BooleanRule& rule,
                                        Constraints constraints,
                                        const support::ProgressStage& stage);

/// Gives the regions with outlines for which is_kept(region) triangles. Needs UpwardRounding.
void triangulate_outlines(const ArrangementInput& input,
                          const std::function<bool(std::uint32_t)>& is_kept,
                          Subdivision& subdivision);

}  // namespace dupin::arrangement
