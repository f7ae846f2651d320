#pragma once

#include <array>
#include <vector>

namespace dupin {

/// A unit vector as files hold it: binary32, of length 1 to rounding.
using Direction = std::array<float, 3>;

/// One direction for each corner of each triangle of a mesh, in the order of the triangles; empty
/// where nothing is known of the surface that the mesh stands for.
using CornerNormals = std::vector<std::array<Direction, 3>>;

}  // namespace dupin
