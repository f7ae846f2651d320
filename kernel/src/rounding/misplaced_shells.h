#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/exact_mesh.h"

namespace dupin::rounding {

/// One triangle, by its place, of each shell that lies on its wrong side after rounding: that is
/// inside out, as its volume has changed its sign; or that came to lie on the other side of another
/// shell, whole, so that it bounds material where there is some around it, or a void where there is
/// none. `mesh` began as the triangles of `before`, whose shells `shell_of` gives: per point the
/// lowest one that triangles connect it to; no point of
/// the surface moved further than `largest_move`. No shell meets itself or another but in corners
/// and edges.
///
/// Lemma: let the region right inside of each of two shells, before, contain a place farther from
/// the shells that bound it than the move. Then neither shell passes over either place, each of
/// which is in the same ones of the two before and after; and as they do not cross, that tells
/// which of them is around the other, if any. Such a place there is in what has more volume than
/// the surroundings of its triangles. So only slivers, and what is in their boxes, or in those of
/// walls as thin as the move, are asked for by rays.
/// O(n), and the triangles of those in whose boxes such ones are, for each of them.
[[nodiscard]] std::vector<std::uint32_t> misplaced_shells(const mesh::MeshView& before,
                                                          std::span<const std::uint32_t> shell_of,
                                                          const mesh::MeshView& mesh,
                                                          double largest_move);

}  // namespace dupin::rounding
