#pragma once

#include <vector>

#include "tessellation/unrolled_face.h"

namespace dupin::tessellation {

/// Whether chains of holes may have gaps, which are bridged.
enum class Bridges { none, across_gaps };

/// Holes of a face that have corners in common, or all but meet, as those of two pipes that pass
/// through a third one about as thick as they are. Where such a chain of holes reaches about the
/// axis there is no way past it, or hardly one: then what bounds the face on either side of it,
/// which has the same sides linked otherwise, and the shortest sides across the gaps, twice; else
/// the holes as they are. `places` are those of all corners.
[[nodiscard]] std::vector<UnrolledCurve> linked_about(std::vector<UnrolledCurve> holes,
                                                      const std::vector<Vec2>& places,
                                                      double around,
                                                      Bridges bridges = Bridges::across_gaps);

}  // namespace dupin::tessellation
