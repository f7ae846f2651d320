#pragma once

#include <cstdint>
#include <optional>

#include "dupin/kernel/mesh.h"

namespace dupin::formats {

/// The first triangle of `mesh` that the mesh read back from its file does not have: as it is, with
/// the same numbers, and joined to the others by the same points. None if all are there, in their
/// order or label by label, and no others. Points that no triangle uses do not count.
[[nodiscard]] std::optional<std::uint32_t> first_difference(const TriMesh& mesh,
                                                            const TriMesh& read_back);

}  // namespace dupin::formats
