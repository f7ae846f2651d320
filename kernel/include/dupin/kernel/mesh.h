#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "dupin/kernel/vec.h"

namespace dupin {

/// Three indices into the points of a mesh, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// Plain triangles: what a file holds, with no promise of any kind (see `check` and `Solid::from`
/// for promises).
struct TriMesh {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  /// One entry per triangle, an index into `names`; empty when the mesh is not labelled.
  std::vector<std::uint32_t> labels;
  /// Names of the labels (part or patch), unique.
  std::vector<std::string> names;
};

}  // namespace dupin
