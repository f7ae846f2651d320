#pragma once

#include "face_boxes.h"

namespace dupin::detail {

struct UnionTopology {
  bool touching = false;       ///< some face of a meets some face of b
  std::size_t components = 0;  ///< of the union, as MeshGapReport says
};

/// `closed`: neither mesh has a boundary.
[[nodiscard]] UnionTopology union_topology(const MeshPair& pair, const FaceBoxes& boxes,
                                           bool closed);

}  // namespace dupin::detail
