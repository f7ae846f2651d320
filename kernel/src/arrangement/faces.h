#pragma once

#include <cstdint>
#include <vector>

#include "incidences.h"
#include "scene.h"
#include "stage.h"

namespace dupin::detail {

/// Pieces of the retriangulated faces. Pieces of one region have no intersection between them.
struct Pieces {
  struct Piece {
    Triangle corners;  ///< oriented as the support of the region's first triangle
    std::uint32_t region;
    std::uint8_t open;  ///< bit i: the edge opposite to corner i bounds the region
  };
  struct Region {
    std::uint32_t first_cover, end_cover;  ///< the triangles that cover it
    std::uint32_t support;                 ///< a triangle whose plane and orientation it has
  };
  BulkVector<Piece> pieces;
  BulkVector<Region> regions;
  std::vector<SignedTriangle> covers;

  [[nodiscard]] std::span<const SignedTriangle> cover(std::uint32_t region) const {
    return std::span(covers).subspan(regions[region].first_cover,
                                     regions[region].end_cover - regions[region].first_cover);
  }
};

/// Stage 5: triangulates every face with the points and segments on it. Adds the points where
/// segments cross to the scene. Needs UpwardRounding.
[[nodiscard]] Pieces retriangulate(Scene& scene, const BooleanRule& rule, Incidences& incidences,
                                   const Stage& stage);

}  // namespace dupin::detail
