#pragma once

#include <string>
#include <string_view>

#include "dupin/io/mesh_format.h"
#include "dupin/io/mesh_header.h"
#include "dupin/kernel/mesh.h"

namespace dupin {

/// Reads the polygons of a Wavefront OBJ: `v`, `f` (with texture and normal indices, skipped, and
/// with negative indices), `g` and `o`. The latest `g` or `o` names the label of the faces after
/// it; faces before any are labelled "default" if others have a name. Faces are cut into triangles
/// as `read_off` does; free-form geometry is refused, and points without any face; everything else
/// is skipped, also numbers of colours that are not finite. Points keep their order and are not
/// merged; -0 becomes 0.
///
/// `file` is named in errors. Throws Error{parse_failed} with "file:line", and
/// Error{limit_exceeded} as `read_off`.
[[nodiscard]] TriMesh read_obj(std::string_view bytes, std::string_view file);

/// OBJ with the shortest decimals that read back to the same doubles and one group `g` per label,
/// in the order of the names. Normals are `vn` of faces `f v//n`, shortest decimals of binary32;
/// points stay shared. Throws Error{invalid_argument} for a non-finite point or normal, a bad
/// index, and normals that are not one per corner.
[[nodiscard]] std::string obj_text(const TriMesh& mesh, const MeshHeader& header = {});

extern const MeshFormat kObj;

}  // namespace dupin
