#pragma once

#include <cstdint>
#include <span>

#include "dupin/kernel/mesh.h"
#include "tessellation/kneecap_joint.h"

namespace dupin::tessellation {

struct KneecapSampling {
  std::uint32_t segments = 0;  ///< around the pieces' circles
  double allowed = 0;          ///< largest distance of a triangle from the sphere
  double grid = 0;
};

/// About how many rows of triangles a kneecap has between its edges; 0 if there is none.
[[nodiscard]] double expected_rows(const JointCircles& joint, std::uint32_t segments);

/// Appends the kneecap of a lune or band between the edges `before` and `after` of the circles'
/// polygons, as indices of the mesh's points: those of a lune share their ends, those of a band are
/// closed and do not repeat the first point. Returns how far the triangles are from the sphere, but
/// for rounding and snapping: rows are arcs of circles of the pencil of both contact circles, as
/// many as `sampling` permits.
double append_kneecap(TriMesh& mesh, const JointCircles& joint,
                      std::span<const std::uint32_t> before, std::span<const std::uint32_t> after,
                      const KneecapSampling& sampling);

}  // namespace dupin::tessellation
