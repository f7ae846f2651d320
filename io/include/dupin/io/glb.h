#pragma once

#include <string>
#include <string_view>

#include "dupin/io/mesh_format.h"
#include "dupin/io/mesh_header.h"
#include "dupin/kernel/mesh.h"

namespace dupin {

/// Reads the triangles of all meshes that the scene of a binary glTF 2.0 file shows, each where its
/// nodes put it: in glTF's metres with y upward. What `glb_bytes` wrote comes back in the mesh's
/// own coordinates: its one node, which only turns and scales to glTF's, is not applied, unless
/// someone gave it another place. Points that are there once for each of their normals are one
/// again. Without
/// scenes all nodes are shown, without nodes all meshes. A mesh that several nodes show is there
/// several times.
///
/// The material of a primitive names its label; where it has none and there are several meshes, the
/// node or mesh does. Primitives of a mesh share points if they share an accessor; strips and fans
/// are read, points and lines are no surface. Files that show
/// no mesh (but for what `glb_bytes` writes for one without triangles), nodes with two parents or
/// in a circle, skins, weights of other shapes, compressed or sparse data, outside buffers and
/// other extensions that change geometry are refused. Throws Error{parse_failed} with the file and
/// the JSON pointer, Error{limit_exceeded} where nodes repeat meshes without measure.
[[nodiscard]] TriMesh read_glb(std::string_view bytes, std::string_view file);

/// The unit that `glb_bytes` noted, which may be empty, of what comes back in the mesh's own
/// coordinates; else "m", which glTF has. Throws like `read_glb`.
[[nodiscard]] std::string unit_of_glb(std::string_view bytes, std::string_view file);

/// Binary glTF 2.0: one mesh with all points in one accessor and one primitive with a material of
/// its own per label. The node turns z upward and, if the header names a unit, scales to metres;
/// the coordinates themselves are only rounded to binary32. With normals, a point with several is
/// there several times: the points come first, then the copies, and the accessor `copies` of
/// asset.extras tells of which points.
///
/// Throws Error{invalid_argument} for a non-finite point or normal, a bad index, an unknown unit,
/// and normals that are not one per corner, Error{unroundable} for a point beyond binary32,
/// Error{limit_exceeded} beyond 4 GiB.
[[nodiscard]] std::string glb_bytes(const TriMesh& mesh, const MeshHeader& header = {});

extern const MeshFormat kGlb;

}  // namespace dupin
