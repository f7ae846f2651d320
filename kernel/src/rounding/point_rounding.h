#pragma once

#include <cstdint>
#include <vector>

#include "exact/float_lattice.h"
#include "mesh/exact_mesh.h"

namespace dupin::rounding {

/// The points of an exact mesh, less an origin, correctly rounded.
struct RoundedPoints {
  std::vector<Vec3> shifted;          ///< to binary64; empty where the mesh has them: origin 0
  std::vector<std::uint8_t> inexact;  ///< where the nearest double is not the exact place
  std::vector<Vec3> on_lattice;       ///< to the lattice, in one rounding
  std::vector<std::uint8_t> moved;    ///< where `on_lattice` is not the exact place
  bool any_inexact = false;
  double largest = 0, largest_on_lattice = 0;  ///< coordinates, in absolute value
  double largest_move = 0;                     ///< from nearest doubles to the lattice
};

[[nodiscard]] RoundedPoints round_points(const mesh::ExactMesh& mesh,
                                         const exact::FloatLattice& lattice, const Vec3& origin);

}  // namespace dupin::rounding
