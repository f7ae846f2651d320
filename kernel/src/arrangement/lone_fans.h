#pragma once

#include "arrangement/input.h"

namespace dupin::arrangement {

/// Of an input without special points whose triangles may cross each other where input.crossing
/// says so: marks as special all points but those around which triangles that cross nothing make
/// one closed fan. Those are as the points of a solid are: each edge there has two triangles, one
/// on either side.
void mark_all_but_lone_fans(ArrangementInput& input);

}  // namespace dupin::arrangement
