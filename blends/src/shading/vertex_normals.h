#pragma once

#include "dupin/kernel/crease.h"
#include "dupin/kernel/mesh.h"
#include "shading/patch_table.h"

namespace dupin::shading {

/// How near a mesh is to the patches.
struct MeshBounds {
  /// A triangle's patch is looked for once more for a corner that is further from it.
  double usual = 0;
  double largest = 0;  ///< beyond, a surface has nothing to do with a corner
  double least_cosine =
      0.25;  ///< of the angle between a triangle's normal and those of its corners
};

/// See dupin::smooth_normals. Of a mesh without labels, all are the triangles' own.
[[nodiscard]] CornerNormals vertex_normals(const PatchTable& table, const TriMesh& mesh,
                                           const MeshBounds& bounds);

}  // namespace dupin::shading
