#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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
/// sources are {0, face of the mesh}. `crossing`: empty, or 1 per face of the mesh that may meet
/// another one but in common corners and edges. Throws like arrangement::arrange().
[[nodiscard]] mesh::ExactMesh wound_around(const PolygonSoup& soup, const TriMesh& mesh,
                                           const Progress& progress = {},
                                           std::span<const std::uint8_t> crossing = {});

/// Divides the soup, which is closed, into shells (closed_shells.h), and turns those of negative
/// volume that an even number of others encloses (shell_enclosure.h; shells of one sign that could
/// be others that cross are one there), and with them those right inside that face them as the
/// walls of cavities do, so that a solid that is all inside out keeps its cavities. `is_turned`
/// says of each triangle whether it is turned. Returns how many shells are left of negative volume,
/// as the walls of cavities.
std::size_t turn_shells_outward(PolygonSoup& soup, std::vector<std::uint8_t>& is_turned);

}  // namespace dupin::healing
