#pragma once

#include <cstddef>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/progress.h"
#include "dupin/kernel/solid.h"

namespace dupin {

struct Simplified {
  TriMesh mesh;
  std::vector<Source> sources;  ///< one per triangle: of the one whose place it takes
  std::size_t removed_triangles = 0;
  /// A bound of the distance from every point of either surface to the other, beyond that of
  /// rounding to doubles; at most the tolerance.
  double deviation = 0;
};

/// A mesh with fewer triangles for the same solid, still closed, 2-manifold and free of
/// self-intersection by exact predicates, with binary64 coordinates. Points vanish by the collapse
/// of edges, the least harmful first; those that stay keep their place. There is a one-to-one map
/// between both surfaces that moves no point further than `tolerance` (model units). Borders
/// between labels keep their course exactly, contacts theirs, and none are added. No face passes
/// over another shell, however small: of each, one point stays, and so does what it is beside.
/// About 20 microseconds per removed triangle. Throws Error{invalid_argument} unless the tolerance
/// is positive and finite, Error{unroundable} as `to_mesh`. Tells the stage "simplify".
[[nodiscard]] Simplified simplify(const Solid& solid, double tolerance,
                                  const Progress& progress = {});

}  // namespace dupin
