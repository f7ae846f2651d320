#pragma once

#include <span>
#include <vector>

#include "exact/ball.h"
#include "mesh/exact_mesh.h"

namespace dupin::mesh {

/// A few triangles, and what balls tell of their points, each point once: for what is thinner than
/// doubles are apart, at a fraction of the cost of exact numbers. All needs rounding upward in the
/// calling thread.
struct BallMesh {
  BallMesh(const MeshView& mesh, std::span<const Triangle> of_mesh);

  std::vector<exact::BallPoint> points;
  std::vector<Triangle> triangles;
};

/// The sign of the volume that the triangles enclose, if they are closed; 0 where the points are
/// not known well enough, too.
[[nodiscard]] int volume_sign(const BallMesh& mesh);

}  // namespace dupin::mesh
