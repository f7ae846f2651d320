#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/surface_distance.h"
#include "meshing/angle_improvement.h"

namespace dupin::meshing {

inline constexpr double kDegree = M_PI / 180;
inline constexpr MoveLimits kLimits{.longest_edge = 100, .distance = 0.01};

/// The plane z = 0, as far as it matters.
struct Plane {
  std::vector<Vec3> points = {Vec3(-50, -50, 0), Vec3(150, -50, 0), Vec3(-50, 150, 0)};
  std::vector<Triangle> triangles = {{0, 1, 2}};
  std::vector<std::uint32_t> regions = {0};
  mesh::ReferenceSurface surface{points, triangles, regions};
};

}  // namespace dupin::meshing
