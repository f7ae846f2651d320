#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dupin/blends/junction.h"
#include "dupin/blends/tessellation.h"

namespace dupin::junction {

struct HubSampling {
  double tolerance = 0.05;
  double grid = 0;
  std::size_t most_triangles = kUsualTriangles;
};

/// What the caps leave of the hub. `circles` are the polygons of cap_circle() of all arms, as their
/// tubes end in them: their points, one polygon after the other, are the mesh's first ones, and no
/// others lie on its boundary. Triangles are counter-clockwise from outside.
///
/// Points are added on the sphere, the centres of triangles' circles in a Delaunay triangulation of
/// the stereographic chart, until triangles are small enough for the tolerance and grow but slowly
/// from those at the circles. `error_bound` is proved of these triangles: central projection pairs
/// the points of both surfaces, but for those next to a circle, which have partners on it.
///
/// Throws Error{infeasible_blend} where polygons touch, having too few segments or caps that all
/// but touch, Error{limit_exceeded} for more triangles than that.
[[nodiscard]] Tessellation hub_mesh(const Junction& junction,
                                    std::span<const std::vector<Vec3>> circles,
                                    const HubSampling& sampling);

}  // namespace dupin::junction
