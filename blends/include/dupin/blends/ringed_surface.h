#pragma once

#include "dupin/blends/radius_law.h"
#include "dupin/blends/spine.h"
#include "dupin/kernel/ring.h"

namespace dupin {

/// A normal ringed (cyclic) surface: circles of radius R(t) about y(t), in the planes orthogonal to
/// y'(t) [MS06] eq. (1). Pipes, cones, elbows and cyclic blends are all of this kind.
///
/// `start` and `end` are the stored end rings, normals pointing out of the part: start.normal =
/// -T(0), end.normal = T(1). They are what neighbours share; the spine and law agree with them to
/// rounding, never the other way round.
struct RingedSurface {
  Ring start, end;
  Spine spine;
  RadiusLaw radius;
};

}  // namespace dupin
