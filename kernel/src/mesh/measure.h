#pragma once

#include <cstdint>
#include <span>

#include <gmpxx.h>

#include "mesh/exact_mesh.h"

namespace dupin::mesh {

/// The volume that the triangles enclose, counted by winding: a sixth of the sum of the
/// determinants of their corners. O(n) where all coordinates are doubles; with n implicit points
/// the common denominator has O(n) digits.
[[nodiscard]] mpq_class exact_volume(const MeshView& mesh);

/// The double nearest to exact_volume, by enclosures that need no common denominator. O(n).
[[nodiscard]] double nearest_volume(const MeshView& mesh);

/// The sign of exact_volume, likewise; of doubles, where rounding leaves no doubt, from these.
[[nodiscard]] int volume_sign(const MeshView& mesh);

/// The sum of the areas of the triangles; relative error below 1e-12.
[[nodiscard]] double area(const MeshView& mesh);

}  // namespace dupin::mesh
