#pragma once

#include <span>

#include "arrangement/broad_phase.h"
#include "arrangement/input.h"

namespace dupin::arrangement {

/// In how many points, on average, the lines cross each other in which other triangles cut a face:
/// an estimate from some of those that are candidates (of broad_phase) and are cut, in floating
/// point, always the same. Such points are what is dear of an arrangement, and most of them are
/// inside of a union. Triangles that have corners which are no doubles are left out.
[[nodiscard]] double crossings_per_face(const ArrangementInput& input,
                                        std::span<const TrianglePair> candidates);

}  // namespace dupin::arrangement
