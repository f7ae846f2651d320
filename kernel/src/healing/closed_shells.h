#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "mesh/edge_table.h"

namespace dupin::healing {

using ShellPair = std::pair<std::uint32_t, std::uint32_t>;

struct ClosedShells {
  mesh::Shells shells;
  /// The lower one first; but for edges of very many faces.
  std::vector<ShellPair> at_one_edge;
  /// Per shell 1 if more than two of its faces are at an edge.
  std::vector<std::uint8_t> touches_itself;
};

/// What faces bound that are paired by angles.
enum class Wedges : std::uint8_t { material, voids };

/// Divides faces that run along each edge as often one way as the other into shells that do, too,
/// however the faces are numbered. Copies of a face may belong to different shells.
///
/// Faces hang together where an edge has two, and copies of two faces where all at an edge are
/// such, one by one. What then has as many faces one way as the other at an edge closes itself
/// there. Of others at the edge, copies of one face do not close each other unless they have to,
/// which may leave only one face that can; else what ends along the same edges as only one other
/// closes it; else of bodies that end along the same edges as copies of one set of faces, if there
/// are as many, each has one of these; else what can be closed there by copies of the same faces
/// only is closed by one of these; and what that leaves open is paired by the exact angles around
/// the edge, level by level of winding: above the middle level as the surfaces of the wedges that
/// are wound around more often, below it of those that are less often, and at it likewise by the
/// sign of the volume of all that hangs together, so that turning everything over changes nothing.
/// What lies on each other there is in layers, the same at all edges. So what crosses itself along
/// edges may become shells of which one is within the other, where others that cross would do as
/// well. For voids, levels pair up the other way: what is wound around less often has a surface of
/// its own.
///
/// O(n), and O(n log n) where angles are needed.
[[nodiscard]] ClosedShells closed_shells(std::span<const Vec3> points,
                                         std::span<const Triangle> triangles,
                                         Wedges wedges = Wedges::material);

}  // namespace dupin::healing
