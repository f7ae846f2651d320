#pragma once

#include <string>
#include <string_view>

#include "dupin/io/mesh_format.h"
#include "dupin/io/mesh_header.h"
#include "dupin/kernel/mesh.h"

namespace dupin {

/// Reads the polygons of a VTK file of polygonal data (XML, `.vtp`), piece after piece, cut into
/// triangles as `read_off` does. Data may be text, or little-endian binary inside the elements;
/// what is compressed or appended is refused, with how to save it otherwise. The cell data `label`,
/// if it is there, is an index into the field data `label_names`; a cell whose name is not there
/// gets one of its number. Vertices and lines are left out, strips are refused. Points keep their
/// order and are not merged.
///
/// `file` is named in errors. Throws Error{parse_failed} with "file:line", and
/// Error{limit_exceeded} as `read_off`.
[[nodiscard]] TriMesh read_vtp(std::string_view bytes, std::string_view file);

/// The unit that `vtp_text` noted, or empty. Throws Error{parse_failed} for faulty XML.
[[nodiscard]] std::string unit_of_vtp(std::string_view bytes, std::string_view file);

/// PolyData with coordinates of binary64, in base64. Of labelled meshes the cell data `label` is
/// the patch and `part` what its name begins with, up to the first dot; the field data
/// `label_names` and `part_names` name both. `unit` and `note` are field data, too. Throws
/// Error{invalid_argument} for a non-finite point or a bad index, Error{limit_exceeded} beyond 2^31
/// corners.
[[nodiscard]] std::string vtp_text(const TriMesh& mesh, const MeshHeader& header = {});

extern const MeshFormat kVtp;

}  // namespace dupin
