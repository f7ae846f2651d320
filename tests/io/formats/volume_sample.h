#pragma once

#include "dupin/kernel/volume_mesh.h"
#include "support/sample_meshes.h"

namespace dupin::test {

/// A tetrahedron in four, about a point inside.
inline VolumeMesh volume_sample() {
  VolumeMesh mesh;
  mesh.surface = labelled_tetrahedron();
  mesh.inner_points.emplace_back(0.1, 1.0 / 3, 0.2);
  for (const auto& [a, b, c] : mesh.surface.triangles) {
    mesh.tetrahedra.push_back({4, a, b, c});
  }
  return mesh;
}

}  // namespace dupin::test
