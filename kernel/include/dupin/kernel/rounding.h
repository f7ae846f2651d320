#pragma once

#include <cstddef>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/solid.h"

namespace dupin {

/// What a file format can hold.
enum class Coordinates { binary64, binary32 };

/// How the one rounding went.
struct RoundingReport {
  Coordinates coordinates = Coordinates::binary64;
  std::size_t moved = 0;    ///< vertices whose coordinates changed
  double largest_move = 0;  ///< an upper bound, in model units
  std::size_t removed_triangles = 0;
};

struct Rounded {
  TriMesh mesh;
  RoundingReport report;
};

struct RoundingOptions {
  double tolerance = 0;  ///< largest move allowed for repair; 0 chooses 1024 ulp of the largest
                         ///< coordinate in the target format
};

/// The one rounding: exact coordinates to representable ones, such that the mesh, identical
/// vertices merged, is still closed, 2-manifold (contacts apart) and free of self-intersection by
/// exact predicates on the rounded numbers. Throws Error{unroundable} naming the place and what
/// would help.
[[nodiscard]] Rounded to_mesh(const Solid& solid, Coordinates coordinates = Coordinates::binary64,
                              const RoundingOptions& options = {});

}  // namespace dupin
