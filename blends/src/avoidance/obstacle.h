#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/blends/part_surface.h"
#include "dupin/blends/spline_pipe.h"
#include "dupin/kernel/mesh.h"
#include "surfaces/pieces/piece_discs.h"

// This folder: pipes that go round obstacles ([mathematics A8]). Obstacles are convex (obstacle.h),
// how far a pipe's discs keep from them is proved in intervals by halving (clearance.h), and the
// way is searched among way-points until a proof succeeds (route.h), then among straight pipes and
// elbows (polyline.h). What has no proof is no way.

namespace dupin::avoidance {

/// An obstacle, or a box that holds others.
struct ObstacleBox {
  Obstacle shape;
  std::vector<ObstacleBox> parts = {};  ///< none: the shape itself is the obstacle
};

struct NamedObstacle {
  std::string name;  ///< as messages call it
  Obstacle shape;
  std::vector<ObstacleBox> parts = {};  ///< as of an ObstacleBox
};

/// A box along the axes.
[[nodiscard]] Obstacle box_about(const Eigen::AlignedBox3d& bounds);

/// The triangles of a mesh, in boxes of boxes along the axes. Throws Error{invalid_argument} for a
/// mesh without triangles, or with coordinates that are not finite. O(n log n).
[[nodiscard]] NamedObstacle obstacle_of(const std::string& name, const TriMesh& mesh);

/// A part as capsules around stretches of its axis: they contain it, and reach beyond its flat ends
/// by up to its radius.
[[nodiscard]] std::vector<NamedObstacle> obstacles_of(const std::string& part,
                                                      const PartSurface& surface);

/// The point of the obstacle's parallelepiped or triangle nearest to `point`, nearly.
[[nodiscard]] Vec3 nearest_core_point(const Obstacle& obstacle, const Vec3& point);

/// How near the disc in a circle and an obstacle come, nearly: negative by at most the obstacle's
/// radius where they meet. `direction` is from the disc to the obstacle.
struct Approach {
  double distance = 0;
  Vec3 place = Vec3::Zero(), direction = Vec3::Zero();
};
[[nodiscard]] Approach approach(const TravelRing& disc, const Obstacle& obstacle);

/// The same distance from what it is made of.
[[nodiscard]] double distance(const TravelRing& disc, const NamedObstacle& obstacle);

/// A proved lower bound of the distance between all discs and the obstacle, from a plane across any
/// direction that is not zero: the obstacle's least less the discs' largest extent along it.
[[nodiscard]] double separation(const surfaces::DiscHull& discs, const Obstacle& obstacle,
                                const Vec3& direction);

}  // namespace dupin::avoidance
