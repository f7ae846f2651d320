#pragma once

#include <string>
#include <string_view>

#include "dupin/io/mesh_header.h"
#include "dupin/io/volume_file.h"
#include "dupin/kernel/volume_mesh.h"

namespace dupin {

/// A VTK file of an unstructured grid (XML, `.vtu`) with coordinates of binary64, in base64: first
/// the triangles of the surface, then the tetrahedra. The cell data `label` and `part` are those of
/// `vtp_text`, and -1 for tetrahedra; names, unit and note are field data as there. Throws
/// Error{invalid_argument} for a non-finite point or a bad index, Error{limit_exceeded} beyond 2^31
/// corners.
[[nodiscard]] std::string vtu_text(const VolumeMesh& mesh, const MeshHeader& header = {});

/// Reads back what `vtu_text` has written, but for names of labels. Throws Error{parse_failed}.
[[nodiscard]] VolumeMesh read_vtu(std::string_view bytes, std::string_view file);

extern const VolumeFormat kVtu;

}  // namespace dupin
