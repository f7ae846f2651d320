#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "bulk_vector.h"
#include "edge_key.h"
#include "scene.h"
#include "triangle_pair.h"

namespace dupin::detail {

/// The edge of a triangle that a feature of it is.
[[nodiscard]] inline EdgeKey edge_of(const Triangle& corners, Feature feature) {
  const std::size_t i = feature - 3u;
  return edge_key(corners[i], corners[(i + 1) % 3]);
}

/// The points at the ends of encounters.
struct Names {
  BulkVector<PointId> ends;      ///< two per encounter, kNone where it has no such end
  std::vector<PointId> corners;  ///< of triangles, met by others; ascending
  PointId first_new_point = 0;
};

/// Finds the corners at ends of encounters, and adds all other ends to the scene: one point for
/// each pair of edges, or of an edge and a plane, that meet there, in order of first appearance.
/// Needs UpwardRounding.
[[nodiscard]] Names name_points(Scene& scene, std::span<const Encounter> encounters);

}  // namespace dupin::detail
