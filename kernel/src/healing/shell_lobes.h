#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "healing/polygon_soup.h"
#include "mesh/exact_mesh.h"

namespace dupin::healing {

/// Some faces of a soup as a surface of their own, perhaps turned; sources count among `faces`.
[[nodiscard]] mesh::ExactMesh surface_of(const PolygonSoup& soup,
                                         std::span<const std::uint32_t> faces, bool turned);

/// Of a closed shell that touches itself along edges: the faces around what it winds around the
/// other way than `sign`, the sign of most of it. With these turned it is closed still and winds
/// around all of it one way; none if that would need to cut faces.
[[nodiscard]] std::vector<std::uint32_t> lobe_faces(const PolygonSoup& soup,
                                                    std::span<const std::uint32_t> faces, int sign);

}  // namespace dupin::healing
