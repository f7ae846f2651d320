#pragma once

#include <string>
#include <string_view>

#include "dupin/io/mesh_format.h"
#include "dupin/io/mesh_header.h"
#include "dupin/kernel/mesh.h"

namespace dupin {

/// Reads the triangles of a binary glTF 2.0 file with one mesh, in the mesh's own coordinates (the
/// node's transformation, which turns and scales to glTF's metres with y upward, is not applied).
/// The material of a primitive names its label; primitives share points if they share an accessor.
///
/// Meant for reading back what `glb_bytes` wrote: files with several meshes, compressed or sparse
/// data, or outside buffers are refused. Throws Error{parse_failed} with the file and the JSON
/// pointer.
[[nodiscard]] TriMesh read_glb(std::string_view bytes, std::string_view file);

/// The unit that `glb_bytes` noted, or empty. Throws like `read_glb`.
[[nodiscard]] std::string unit_of_glb(std::string_view bytes, std::string_view file);

/// Binary glTF 2.0: one mesh with all points in one accessor and one primitive with a material of
/// its own per label. The node turns z upward and, if the header names a unit, scales to metres;
/// the coordinates themselves are only rounded to binary32.
///
/// Throws Error{invalid_argument} for a non-finite point, a bad index or an unknown unit,
/// Error{unroundable} for a point beyond binary32, Error{limit_exceeded} beyond 4 GiB.
[[nodiscard]] std::string glb_bytes(const TriMesh& mesh, const MeshHeader& header = {});

extern const MeshFormat kGlb;

}  // namespace dupin
