#pragma once

#include "arrangement/triangle_intersection.h"

namespace dupin::arrangement {

/// What two coplanar triangles have in common: corners on or in the other one, crossings of edges,
/// and whether it has an area. Needs UpwardRounding.
void intersect_coplanar(const ArrangementInput& input, std::uint32_t first, std::uint32_t second,
                        std::vector<TriangleIntersection>& intersections);

}  // namespace dupin::arrangement
