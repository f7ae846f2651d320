#pragma once

#include <cstdint>
#include <vector>

#include "dupin/kernel/repair.h"

/// Solids from meshes that are none, and solids without contacts, by steps that are exact and can
/// be said in one sentence each. repair() merges points, drops faces without area and copies of
/// faces, turns faces until they agree, and takes what the surface then winds around a positive
/// number of times (arrangement::positive_winding_boundary); it moves no point and fills no hole.
/// separate() and bridge() (contacts.cpp) cut away or add small polyhedra around contacts. Here are
/// the steps on a soup: triangles of which nothing is known but that their indices are in range.
namespace dupin::healing {

/// Triangles on their way to becoming a solid.
struct PolygonSoup {
  std::vector<Vec3> points;  ///< finite
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> sources;  ///< the face of the first mesh that each triangle is from
};

/// The mesh with points of identical coordinates as one. Its points are finite and its indices in
/// range.
[[nodiscard]] PolygonSoup merge_duplicate_points(const TriMesh& mesh, RepairReport& report);

/// Drops triangles without area. One with three different corners goes by splitting the triangles
/// across its longest edge at the corner between, so that no slit opens; it stays if there are
/// none.
void drop_degenerate_faces(PolygonSoup& soup, RepairReport& report);

/// Drops copies of triangles. Of those that cover the same area both ways, one stays if the
/// surface needs it to be closed, else none.
void drop_duplicate_faces(PolygonSoup& soup, RepairReport& report);

/// Turns triangles so that those at an edge of two run along it in opposite directions, as most of
/// them do already, and shells that no other encloses so that their volume is positive. Throws
/// Error{not_oriented} for a surface with one side.
void orient_soup(PolygonSoup& soup, RepairReport& report);

}  // namespace dupin::healing
