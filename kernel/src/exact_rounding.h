#pragma once

#include <cstdint>
#include <vector>

#include "exact_mesh.h"
#include "lattice.h"

namespace dupin::detail {

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

[[nodiscard]] RoundedPoints round_points(const ExactMesh& mesh, const Lattice& lattice,
                                         const Vec3& origin);

/// For each point the first one in exactly the same place: another one only at contacts.
[[nodiscard]] std::vector<std::uint32_t> exact_twins(const ExactMesh& mesh);

/// The same for a mesh whose contacts are known; quick if there are none.
[[nodiscard]] std::vector<std::uint32_t> twins_at_contacts(const ExactMesh& mesh);

}  // namespace dupin::detail
