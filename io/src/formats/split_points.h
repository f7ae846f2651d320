#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "dupin/kernel/crease.h"
#include "dupin/kernel/mesh.h"

namespace dupin::formats {

/// A mesh whose vertices have one normal each, for formats that know no others: the mesh's points,
/// in their order, and after them copies of those that have several.
struct SplitPoints {
  std::vector<Triangle> triangles;    ///< of vertices, in the mesh's order
  std::vector<Direction> normals;     ///< of the points, then of the copies
  std::vector<std::uint32_t> copied;  ///< of each copy, the point
};

/// Points that have a normal in another mesh, too: there this one is their vertex's.
using GivenNormals = std::map<std::uint32_t, Direction>;

/// As few copies as there can be. Points that no triangle uses get the z axis. O(n). Throws
/// Error{invalid_argument} unless there are as many normals as triangles, all finite; indices are
/// taken to be in range.
[[nodiscard]] SplitPoints split_points(const TriMesh& mesh, const CornerNormals& normals,
                                       const GivenNormals& given = {});

/// Undoes it, of a mesh whose last points are copies of these; false, with the mesh as it was,
/// where they are not, coordinate by coordinate.
[[nodiscard]] bool merge_copies(const std::vector<std::uint32_t>& copied, TriMesh& mesh);

}  // namespace dupin::formats
