#pragma once

#include "healing/polygon_soup.h"
#include "mesh/exact_mesh.h"

namespace dupin::healing {

/// Whether all of the soup is in the boundary of what it winds around, be it in other pieces: then
/// it did neither cross nor cover nor enclose itself. Exact. O(n log n), with exact numbers only
/// for triangles that were divided, and only where areas as doubles do not tell.
[[nodiscard]] bool keeps_surface(const mesh::ExactMesh& solid, const PolygonSoup& soup);

}  // namespace dupin::healing
