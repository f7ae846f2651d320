#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin {

/// What the meshes of a document may ask for unless more is allowed: seconds of work, two
/// gigabytes.
constexpr std::size_t kUsualTriangles = 4'000'000;

/// Around a ring.
constexpr std::uint32_t kFewestSegments = 3, kMostSegments = 1'000'000;

struct TessellationOptions {
  /// Largest distance between the smooth surface and the mesh, both ways, in model units.
  double tolerance = 0.05;
};

/// Triangles of one part and a proof of how far they are from it.
struct Tessellation {
  TriMesh mesh;
  std::uint32_t bands = 0;  ///< rows of quadrilaterals along the part
  double error_bound = 0;  ///< of the distance between smooth surface and mesh, both ways, in model
                           ///< units; includes snapping
  /// The parameters of the rows, i + t on the i-th piece; none for spheres, chains with kneecaps
  /// and hollow chains.
  std::vector<double> knots = {};
  double axes = 0;  ///< radians by which axes of rows that are ellipses may be turned
};

}  // namespace dupin
