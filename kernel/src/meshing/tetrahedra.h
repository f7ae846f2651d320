#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/volume_mesh.h"

namespace dupin::meshing {

/// Where a point may move.
enum class Freedom : std::uint8_t { none, region, inside };

/// Tetrahedra, and the triangles that bound them, turned outward.
struct Tetrahedra {
  std::vector<Vec3> points;
  std::vector<Freedom> freedoms;  ///< per point
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> regions;  ///< per triangle
};

/// The faces of a positive tetrahedron, turned outward, each opposite to the corner of its number.
[[nodiscard]] inline std::array<Triangle, 4> faces_of(const Tetrahedron& t) {
  return {Triangle{t[1], t[2], t[3]}, Triangle{t[0], t[3], t[2]}, Triangle{t[0], t[1], t[3]},
          Triangle{t[0], t[2], t[1]}};
}

/// Whether the four points turn as those of a tetrahedron do, exactly.
[[nodiscard]] bool is_positive(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace dupin::meshing
