#pragma once

#include "dupin/kernel/corner_normals.h"
#include "dupin/kernel/mesh.h"
#include "shading/patch_table.h"

namespace dupin::shading {

/// See dupin::smooth_normals: `reach` is how far points may be from the surfaces, `least_cosine`
/// that of the largest angle between a triangle's normal and those at its corners. Of a mesh
/// without labels, all are the triangles' own.
[[nodiscard]] CornerNormals vertex_normals(const PatchTable& table, const TriMesh& mesh,
                                           double reach, double least_cosine);

}  // namespace dupin::shading
