#pragma once

#include <cstddef>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/progress.h"
#include "dupin/kernel/solid.h"

namespace dupin {

/// What repair() changed; all zero for a mesh that was a solid already.
struct RepairReport {
  std::size_t merged_points = 0;     ///< points that were copies of others
  std::size_t degenerate_faces = 0;  ///< dropped for having no area
  std::size_t duplicate_faces = 0;   ///< dropped for covering others
  std::size_t turned_faces = 0;      ///< their corners now run the other way round
  std::size_t cavities = 0;          ///< shells inside out in others, whose walls they stay
  bool united_overlaps = false;      ///< the surface crossed or covered itself, or enclosed itself
  /// The surface touched itself, or a corner lay on an edge: faces are divided and points double.
  bool parted_contacts = false;
  friend bool operator==(const RepairReport&, const RepairReport&) = default;
};

struct Repaired {
  Solid solid;
  RepairReport report;
};

/// A solid from a mesh that is none, by steps that move nothing and invent nothing: merges points
/// of identical coordinates; drops faces without area (the neighbour across the longest edge takes
/// the corner on it) and copies of faces; turns faces to agree with most of those they hang
/// together with, and shells inside out that no other one is around, with the walls of the cavities
/// in them; keeps the places that the surface then winds around a positive number of times. Sources
/// name the faces of `mesh`.
///
/// A shell is closed, and may share faces, edges and points with others: what ends along the same
/// edges as only one other closes it, copies of a face that look opposite ways belong to different
/// shells, and where that leaves a choice, the exact angles around an edge tell which faces bound
/// the same wedge, of material or inside out (the level of winding in the middle is read by the
/// sign of the volume of all that hangs together, so that turning everything over changes nothing
/// but where that is zero). What a shell that touches itself at edges winds around the other way
/// than most is turned, too. One shell is around another if this is nowhere outside of it, though
/// they may touch; not if they cross, or have the same faces. Points are taken in the order of
/// their coordinates where faces do not agree: the order of faces and points does not matter for
/// what is kept of meshes without degenerate faces.
///
/// What bodies have in common that cross along edges, and what would be lost and can only be of
/// bodies (lost_cells.h), is part of the solid. Holes are never filled. Throws
/// Error{invalid_argument} for what is no mesh (points that are not finite or out of range, bad
/// indices or labels), Error{not_closed | not_oriented} where more would have to be guessed, or a
/// body would be lost that faces bound where the surface had to be closed or touches itself, and
/// what unite() throws.
[[nodiscard]] Repaired repair(const TriMesh& mesh, const Progress& progress = {});

}  // namespace dupin
