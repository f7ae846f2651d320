#pragma once

#include <cstdint>
#include <optional>

#include "dupin/kernel/mesh.h"

// This folder: one .cpp, or a few of one prefix, per mesh format, each behind one row (MeshFormat,
// dupin/io/mesh_format.h) that mesh_file.cpp lists. Readers take bytes and give a TriMesh or an
// error with line or byte; nothing is allocated that the size of the file does not justify. Writers
// give the same bytes for the same mesh. mesh_file_verified.cpp writes aside, reads back, compares
// (below) and checks before the name appears.

namespace dupin::formats {

/// The first triangle of `mesh` that the mesh read back from its file does not have: as it is, with
/// the same numbers, and joined to the others by the same points. None if all are there, in their
/// order or label by label, and no others. Points that no triangle uses do not count.
[[nodiscard]] std::optional<std::uint32_t> first_difference(const TriMesh& mesh,
                                                            const TriMesh& read_back);

}  // namespace dupin::formats
