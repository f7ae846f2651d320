#pragma once

#include <array>

#include <gmpxx.h>

#include "mesh/exact_mesh.h"

namespace dupin::mesh {

/// For each axis twice the areas of the triangles as seen along it, added up, whichever way they
/// turn: what a triangle is divided into has the same. Exact; O(n) with doubles, and with n
/// implicit points the sums have O(n) digits.
[[nodiscard]] std::array<mpq_class, 3> projected_areas(const MeshView& mesh);

}  // namespace dupin::mesh
