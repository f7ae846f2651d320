#pragma once

#include <string>
#include <string_view>

#include "dupin/io/mesh_format.h"
#include "dupin/io/mesh_header.h"
#include "dupin/kernel/mesh.h"

namespace dupin {

/// Reads the model of a 3MF package: every item of its build, with its transformation, components
/// resolved, also those in other parts (p:path of the production extension, which must be in the
/// root's unit). A model without a build, or whose build shows no triangle, is refused, but for
/// what `three_mf_bytes` writes for a mesh without any. A triangle's label is its base material if
/// it has one of its own, else its object's name ("object ID" where only others have one).
/// Textures, colours and slices are skipped; shapes that are not their triangles (beam lattices,
/// Boolean shapes, displacements, meshes of low resolution beside slices) and required extensions
/// that are not known are refused. Points keep their order and are not merged; -0 becomes
/// 0. Coordinates are in the package's unit.
///
/// `file` is named in errors. Throws Error{parse_failed} with the file, the part of the package and
/// the line, and Error{limit_exceeded} for a package that expands beyond all measure.
[[nodiscard]] TriMesh read_3mf(std::string_view bytes, std::string_view file);

/// The unit of the package's coordinates as in MeshHeader. Throws like `read_3mf`.
[[nodiscard]] std::string unit_of_3mf(std::string_view bytes, std::string_view file);

/// A 3MF package with one object, so that a solid stays one whole; its labels are base materials.
/// Coordinates are rounded and printed as in `stl_ascii_text`, so that readers of either precision
/// find the same mesh. The unit is millimetres unless the header names another.
///
/// Throws Error{invalid_argument} for a non-finite point, a bad index or a unit that 3MF does not
/// know, Error{unroundable} for a point beyond binary32.
[[nodiscard]] std::string three_mf_bytes(const TriMesh& mesh, const MeshHeader& header = {});

extern const MeshFormat kThreeMf;

}  // namespace dupin
