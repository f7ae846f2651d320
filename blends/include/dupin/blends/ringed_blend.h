#pragma once

#include "dupin/blends/moving_ring.h"
#include "dupin/blends/rational_ringed_surface.h"

namespace dupin {

/// The tangent blend of bidegree (9, 2) between two moving rings. Throws Error{invalid_argument}
/// for bad numbers, Error{infeasible_blend} for opposite normals (put a ring between), and
/// Error{irregular_surface} if its discs are not proven to be disjoint locally.
[[nodiscard]] RationalRingedSurface ringed_blend(const MovingRing& from, const MovingRing& to);

/// An end in contact with a canal surface: see along_canal.
struct CanalEnd {
  TravelRing ring;
  double slope = 0, speed = 1;
};

/// The tangent blend of bidegree (5, 2) between canal surfaces; throws as ringed_blend.
[[nodiscard]] RationalRingedSurface canal_ringed_blend(const CanalEnd& from, const CanalEnd& to);

}  // namespace dupin
