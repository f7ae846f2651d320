#pragma once

#include "gaps/mesh_pair.h"

namespace dupin::gaps {

struct UnionTopology {
  bool touching = false;       ///< some face of a meets some face of b
  std::size_t components = 0;  ///< of the union, as MeshGapReport says
};

/// `closed`: neither mesh has a boundary.
[[nodiscard]] UnionTopology union_topology(const MeshPair& pair, const FaceBoxIndex& boxes,
                                           bool closed);

}  // namespace dupin::gaps
