#pragma once

#include <cstdint>
#include <span>

#include "healing/polygon_soup.h"
#include "mesh/exact_mesh.h"

namespace dupin::healing {

/// Throws Error{not_oriented} if something that faces of `given` bound is neither in the solid nor
/// a cavity of it: they are neither on its boundary nor within it. `settled`: the closed surface
/// that it is made of; `is_of_cavity`: per face of the mesh. Sheets of no volume may be dropped.
///
/// It looks at points in each face that is not on the boundary: O(log n) for each, and the faces
/// that a ray meets.
void refuse_lost_faces(const PolygonSoup& given, const PolygonSoup& settled,
                       const mesh::ExactMesh& solid, std::span<const std::uint8_t> is_of_cavity);

}  // namespace dupin::healing
