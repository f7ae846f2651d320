#pragma once

#include <string>
#include <vector>

#include "dupin/kernel/vec.h"

namespace dupin {

/// A place where the boundary of a solid touches itself without being 2-manifold there as a point
/// set (vertices are duplicated, so the surface is 2-manifold combinatorially).
struct Contact {
  enum class Kind { vertex, edge };
  Kind kind = Kind::vertex;
  Vec3 from, to;                   ///< the edge's ends, or the vertex twice
  std::vector<std::string> names;  ///< labels of the faces that meet there, sorted, unique
};

}  // namespace dupin
