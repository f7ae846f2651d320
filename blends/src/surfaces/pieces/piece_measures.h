#pragma once

#include <vector>

#include "dupin/blends/part_measures.h"

namespace dupin::surfaces {

/// Of one piece between its end discs; see dupin::measures.
[[nodiscard]] PartMeasures measures(const Piece& piece);

/// A ball and what planes cut off it: beyond each plane, at `height` from the centre along a unit
/// vector. The segments must not overlap.
struct CutPlane {
  Vec3 direction = Vec3::UnitZ();
  double height = 0;
};
[[nodiscard]] SolidMoments cut_ball(const Sphere& ball, const std::vector<CutPlane>& cuts);

}  // namespace dupin::surfaces
