#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "avoidance/obstacle.h"

namespace dupin::avoidance {

/// Where a pipe comes too near.
struct TightSpot {
  std::size_t piece = 0, obstacle = 0;
  double parameter = 0;  ///< of the piece
  Obstacle shape;        ///< the obstacle's part that is nearest
  double distance = 0;   ///< there, nearly
  Vec3 place = Vec3::Zero();
};

/// What was proved of a pipe and all obstacles.
struct Clearance {
  double least = 0;  ///< a proved lower bound, at least the wanted one; nothing if there is a spot
  std::optional<TightSpot> spot;  ///< where it is less, or nothing could be proved
};

/// That all discs keep at least `wanted` from all obstacles. Stretches are halved until planes
/// between them and each obstacle prove it, in outward rounded arithmetic; the spot is the tightest
/// of those that refute it. Least is infinite without obstacles.
[[nodiscard]] Clearance prove_clearance(std::span<const Piece> pipe,
                                        std::span<const NamedObstacle> obstacles, double wanted);

/// Of a pipe that comes too near somewhere, the spot that is nearest, within a part in 1000, or one
/// where it runs into something.
[[nodiscard]] TightSpot tightest_spot(std::span<const Piece> pipe,
                                      std::span<const NamedObstacle> obstacles,
                                      const TightSpot& known);

[[nodiscard]] Clearance prove_clearance(std::span<const RingedSurface> pipe,
                                        std::span<const NamedObstacle> obstacles, double wanted);

}  // namespace dupin::avoidance
