#pragma once

#include <string_view>

#include "dupin/kernel/mesh.h"

namespace dupin::formats {

/// Whether the file is a binary STL of the triangles of `mesh`, in their order and with the very
/// same numbers. If the points of the mesh are in different places, `read_stl_binary` then joins
/// the triangles as the mesh does; this comparison merges no points and takes a tenth of the time.
[[nodiscard]] bool stl_binary_lists(const TriMesh& mesh, std::string_view bytes);

}  // namespace dupin::formats
