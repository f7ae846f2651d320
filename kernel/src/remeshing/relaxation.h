#pragma once

#include <cstddef>

#include "remeshing/edit_check.h"

namespace dupin::remeshing {

/// Moves every point once towards the middle of what is around it, over its region or along its
/// curve, where that does not spoil angles.
void relax_points(Workshop& shop);

/// Moves points of triangles with angles smaller than asked for to where the smallest of the angles
/// around is larger. How many were moved.
std::size_t widen_angles(Workshop& shop);

}  // namespace dupin::remeshing
