#pragma once

#include "dupin/blends/part_surface.h"
#include "dupin/kernel/ring.h"

namespace dupin::surfaces {

/// What a mesh costs that is not made yet, about.
struct MeshCost {
  double triangles = 0;
  /// Pairs of triangles whose boxes overlap because they lie side by side along a straight part of
  /// its whole length: each is compared with each.
  double pairs = 0;
};

/// Of tessellate() with this sampling: bounds of second derivatives, added up. Takes as long for a
/// mesh of any size. Throws as tessellate() does.
[[nodiscard]] MeshCost mesh_cost(const Chain& chain, const RingSampling& sampling,
                                 double tolerance);
[[nodiscard]] MeshCost mesh_cost(const Sphere& sphere, const RingSampling& sampling,
                                 double tolerance);

}  // namespace dupin::surfaces
