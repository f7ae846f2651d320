#pragma once

#include <string>
#include <vector>

#include "dupin/blends/part_surface.h"
#include "dupin/blends/spline_pipe.h"
#include "surfaces/piece_discs.h"

// This folder: pipes that go round obstacles ([mathematics A8]). Obstacles are convex (obstacle.h),
// how far a pipe's discs keep from them is proved in intervals by halving (clearance.h), and the
// way is searched among way-points until a proof succeeds (route.h). What has no proof is no way.

namespace dupin::avoidance {

struct NamedObstacle {
  std::string name;  ///< as messages call it
  Obstacle shape;
};

/// A part as capsules around stretches of its axis: they contain it, and reach beyond its flat ends
/// by up to its radius.
[[nodiscard]] std::vector<NamedObstacle> obstacles_of(const std::string& part,
                                                      const PartSurface& surface);

/// The point of the obstacle's parallelepiped nearest to `point`, nearly.
[[nodiscard]] Vec3 nearest_core_point(const Obstacle& obstacle, const Vec3& point);

/// How near the disc in a circle and an obstacle come, nearly: negative by at most the obstacle's
/// radius where they meet. `direction` is from the disc to the obstacle.
struct Approach {
  double distance = 0;
  Vec3 place = Vec3::Zero(), direction = Vec3::Zero();
};
[[nodiscard]] Approach approach(const TravelRing& disc, const Obstacle& obstacle);

/// A proved lower bound of the distance between all discs and the obstacle, from a plane across any
/// direction that is not zero: the obstacle's least less the discs' largest extent along it.
[[nodiscard]] double separation(const surfaces::DiscHull& discs, const Obstacle& obstacle,
                                const Vec3& direction);

}  // namespace dupin::avoidance
