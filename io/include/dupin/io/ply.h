#pragma once

#include <string>
#include <string_view>

#include "dupin/io/mesh_format.h"
#include "dupin/io/mesh_header.h"
#include "dupin/kernel/mesh.h"

namespace dupin {

/// Reads PLY 1.0, as text or as bytes of either order. Needs an element `vertex` with the
/// properties x, y and z of any type, and before its end an element `face` with a list
/// `vertex_indices` (or `vertex_index`); faces are cut into triangles as `read_off` does.
///
/// An integer property `label` of the faces gives labels; comments "label NAME", one per label and
/// in their order, give the names. All other elements and properties are skipped, whatever
/// numbers they are, but for the integer property `dupin_point` of our own vertices, which are
/// merged by it. Points without any face are refused. -0 becomes 0.
///
/// `file` is named in errors. Throws Error{parse_failed} with "file:line", or "file:byte N" in a
/// binary body, and Error{limit_exceeded} as `read_off`.
[[nodiscard]] TriMesh read_ply(std::string_view bytes, std::string_view file);

/// PLY text with the shortest decimals that read back to the same doubles; labels as described at
/// `read_ply`. With normals, vertices have them as floats nx, ny and nz, and a point with several
/// is several vertices: the points in their order, then the copies. Where there are copies, the
/// property `dupin_point` of every vertex is the number of the point that it is. Throws
/// Error{invalid_argument} for a non-finite point or normal, a bad index, and normals that are not
/// one per corner.
[[nodiscard]] std::string ply_ascii_text(const TriMesh& mesh, const MeshHeader& header = {});

/// Little-endian PLY whose coordinates are doubles. Throws as `ply_ascii_text`.
[[nodiscard]] std::string ply_binary_bytes(const TriMesh& mesh, const MeshHeader& header = {});

extern const MeshFormat kPlyAscii, kPlyBinary;

}  // namespace dupin
