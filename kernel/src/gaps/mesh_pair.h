#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::gaps {

/// Two meshes over one list of points in which identical points have one index: that of the first.
struct MeshPair {
  std::vector<Vec3> points;           ///< those of a, then those of b
  std::vector<Triangle> triangles;    ///< likewise, without those that repeat a corner
  std::vector<std::uint32_t> source;  ///< the triangle's index in its mesh
  std::vector<std::uint8_t> flat;     ///< corners on one line
  std::uint32_t points_of_a = 0, faces_of_a = 0;
  std::size_t flat_faces = 0;  ///< with those left out

  [[nodiscard]] bool in_a(std::uint32_t face) const { return face < faces_of_a; }
  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t face) const {
    const Triangle& t = triangles[face];
    return {points[t[0]], points[t[1]], points[t[2]]};
  }
  [[nodiscard]] std::span<const Triangle> of_a() const {
    return std::span(triangles).first(faces_of_a);
  }
  [[nodiscard]] std::span<const Triangle> of_b() const {
    return std::span(triangles).subspan(faces_of_a);
  }
};

/// Throws Error{invalid_argument} for a point that is not finite or an index out of range.
[[nodiscard]] MeshPair merged(const TriMesh& a, const TriMesh& b);

}  // namespace dupin::gaps
