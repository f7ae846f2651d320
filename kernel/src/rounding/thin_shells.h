#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/float_lattice.h"
#include "mesh/exact_mesh.h"

namespace dupin::rounding {

/// How points moved to a lattice: less an origin, each to its nearest place, or, where `all_by` is
/// not 0, in ways of which only is known that none is longer.
struct PointMoves {
  const exact::FloatLattice& lattice;
  Vec3 origin = Vec3::Zero();
  double all_by = 0;
};

/// ThinShell in dupin/kernel/rounding.h.
struct MovedShell {
  Vec3 place = Vec3::Zero();
  double thickness = 0, move = 0;
};

/// The shells whose thickness is smaller than the move of one of their points, in the order of
/// their first points. `shell_of`: per point the first one of its shell. `longest` bounds all
/// moves. O(n).
[[nodiscard]] std::vector<MovedShell> thin_shells(const mesh::ExactMesh& exact,
                                                  std::span<const std::uint32_t> shell_of,
                                                  const PointMoves& moves, double longest);

}  // namespace dupin::rounding
