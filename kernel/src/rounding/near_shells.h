#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/exact_mesh.h"

namespace dupin::rounding {

/// The triangles of those shells, none of `moving`, that may lie within `reach` of these from end
/// to end, and so be passed over whole: other shells have a triangle that is farther from the box
/// of each of `moving`. Sweeps over the mesh, and the triangles close to those that move.
[[nodiscard]] std::vector<std::uint32_t> faces_of_near_shells(const mesh::MeshView& mesh,
                                                              std::span<const std::uint32_t> moving,
                                                              double reach);

}  // namespace dupin::rounding
