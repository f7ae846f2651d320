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

/// True if it is certain that no shell turns inside out, nor comes to lie on the other side of
/// another one, while the points that `moved` has a 1 for, not a 0, come from anywhere within
/// `largest_move` to where `mesh` has them. Before and after, no shell may meet itself or another.
///
/// Which side of a shell is inside shows in the winding numbers of the shell on both sides of any
/// of its places, and which shells are around it in theirs; and these only change where a shell
/// passes. So a place that stays, farther than the move from all triangles that do not, tells that
/// the shell around it keeps its sides and its depth. Such places are looked for next to these
/// triangles, and on shells that lie near them from end to end: few sweeps over the mesh, and
/// nearly nothing besides where few points moved.
[[nodiscard]] bool keeps_shell_orientation(const mesh::MeshView& mesh,
                                           std::span<const std::uint8_t> moved,
                                           double largest_move);

}  // namespace dupin::rounding
