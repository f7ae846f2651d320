#pragma once

#include <cstdint>
#include <span>

#include "mesh/exact_mesh.h"

namespace dupin::rounding {

/// True if it is certain that no shell turns inside out while the points that `moved` has a 1 for,
/// not a 0, come from anywhere within `largest_move` to where `mesh` has them. Before and after, no
/// shell may meet itself.
///
/// Which side of a shell is inside shows in the winding numbers of the shell on both sides of any
/// of its places, and these only change where the shell passes. So a place that stays, farther than
/// the move from all triangles that do not, tells that the shell around it keeps its sides. Such
/// places are looked for next to these triangles: two sweeps over the mesh, and nearly nothing
/// besides where few points moved.
[[nodiscard]] bool keeps_shell_orientation(const mesh::MeshView& mesh,
                                           std::span<const std::uint8_t> moved,
                                           double largest_move);

}  // namespace dupin::rounding
