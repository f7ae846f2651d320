#pragma once

#include "triangle_pair.h"

namespace dupin::detail {

/// What two coplanar triangles have in common: corners on or in the other one, crossings of edges,
/// and whether it has an area. Needs UpwardRounding.
void meet_coplanar(const Scene& scene, std::uint32_t first, std::uint32_t second,
                   std::vector<Encounter>& encounters);

}  // namespace dupin::detail
