#pragma once

#include <string>
#include <string_view>

#include "dupin/io/mesh_format.h"
#include "dupin/io/mesh_header.h"
#include "dupin/kernel/mesh.h"

namespace dupin {

/// Reads the surface of a gmsh mesh, MSH 2.2 in text: triangles and quadrangles of the first order,
/// cut as `read_off` does. Their physical surface names the label, by `$PhysicalNames` or else by
/// its number; files without physical surfaces have no labels. Points, lines and other sections are
/// left out; solid elements and those of higher order are refused, and so are other versions, with
/// how to save this one. Nodes keep their order and are not merged.
///
/// `file` is named in errors. Throws Error{parse_failed} with "file:line".
[[nodiscard]] TriMesh read_msh(std::string_view bytes, std::string_view file);

/// MSH 2.2 in text, with the shortest decimals that read back to the same doubles; each label is a
/// physical surface and an elementary one of its own. Unit and note are in a section `$Comments`.
/// Throws Error{invalid_argument} for a non-finite point or a bad index.
[[nodiscard]] std::string msh_text(const TriMesh& mesh, const MeshHeader& header = {});

extern const MeshFormat kMshSurface;

}  // namespace dupin
