#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "arrangement/arrange.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/progress.h"
#include "mesh/exact_mesh.h"

/// Solids from meshes that are none, and solids without contacts, by steps that are exact and can
/// be said in one sentence each. repair() merges points, drops faces without area
/// (degenerate_faces.h) and copies of faces, turns faces until they agree (face_copies.h), and
/// takes what the surface then winds around a positive number of times
/// (arrangement::positive_winding_boundary); it moves no point and fills no hole. separate() and
/// bridge() (contacts.cpp) cut away or add small polyhedra around contacts. Here is the soup that
/// repair() works on: triangles of which nothing is known but that their indices are in range.
namespace dupin::healing {

/// Triangles on their way to becoming a solid.
struct PolygonSoup {
  std::vector<Vec3> points;  ///< finite
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> sources;  ///< the face of the first mesh that each triangle is from
};

/// The mesh with points of identical coordinates as one, and how many were copies of others. Its
/// points are finite and its indices in range.
struct MergedPoints {
  PolygonSoup soup;
  std::size_t copies = 0;
};
[[nodiscard]] MergedPoints merge_duplicate_points(const TriMesh& mesh);

/// What the soup winds around a positive number of times, with the labels of the mesh it is from;
/// sources are {0, face of the mesh}. Throws like arrangement::arrange().
[[nodiscard]] mesh::ExactMesh wound_around(const PolygonSoup& soup, const TriMesh& mesh,
                                           const Progress& progress = {});
/// The same, and what of the soup is neither on it nor within. `crossing`: 1 per face of the mesh
/// that may meet another one but in common corners and edges.
[[nodiscard]] arrangement::WoundSurface wound_surface(const PolygonSoup& soup, const TriMesh& mesh,
                                                      std::span<const std::uint8_t> crossing);

/// The shells of negative volume that are the walls of cavities.
struct Cavities {
  std::size_t count = 0;
  std::vector<std::uint32_t> faces;  ///< of the mesh
  bool touching = false;             ///< some shell, a cavity's or not, touches itself at an edge
};

/// Divides the soup, which is closed, into shells (closed_shells.h), turns what one of them winds
/// around the other way than most (shell_lobes.h), and then, from outside to inside
/// (shell_enclosure.h), those inside out that are no cavities. Within material a shell is a
/// cavity's wall if it faces the other way than all those right around it, so that a solid that is
/// all inside out keeps its cavities; or if they are inside out as it is and have no edge in common
/// with it: else they could as well be others that cross. No shell with a triangle that `is_paired`
/// is one. `is_turned` says of each triangle whether it is turned.
Cavities turn_shells_outward(PolygonSoup& soup, std::span<const std::uint8_t> is_paired,
                             std::vector<std::uint8_t>& is_turned);

}  // namespace dupin::healing
