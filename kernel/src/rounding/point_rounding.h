#pragma once

#include <cstdint>
#include <vector>

#include "exact/float_lattice.h"
#include "mesh/exact_mesh.h"

/// The one rounding: a solid with exact coordinates becomes a mesh of representable numbers that is
/// a solid by exact tests on these numbers (dupin/kernel/rounding.h). In 3D no way is known that is
/// both close to the mesh and quick for all inputs [DLL18]; here the nearest numbers nearly always
/// do, and what they break is repaired nearby.
///
/// In order, as rounding.cpp strings them together: points go to the lattice (this file); faults
/// are found among triangles with a point that moved (edits/fault_tracker.h), and shells that
/// turned inside out or came through another, whole (shell_orientation.h if it is certain that none
/// did, else misplaced_shells.h). Where very much is thinner than a step it is thickened before
/// (edits/thicken_in_slabs.h). Then sliver voids are filled (sliver_voids.h), and slits between
/// ends that nearly meet (open_slits.h); what still is broken is copied with its surroundings
/// (edits/mesh_part.h), edited (edits/edited_mesh.h) as edits/edit_strategy.h says, with growing
/// reach, and put back. What that leaves is cut at itself (self_crossings.h), and all begins again.
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
