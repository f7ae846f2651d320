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

/// A place where the boundary of a solid touches itself without being 2-manifold there as a point
/// set (vertices are duplicated, so the surface is 2-manifold combinatorially).
struct Contact {
  enum class Kind { vertex, edge };
  Kind kind = Kind::vertex;
  Vec3 from, to;                   ///< the edge's ends, or the vertex twice
  std::vector<std::string> names;  ///< labels of the faces that meet there, sorted, unique
};

}  // namespace dupin
