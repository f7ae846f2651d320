#pragma once

#include "healing/polygon_soup.h"

namespace dupin::healing {

/// Throws Error{not_closed} if the soup has edges that are run along more often one way than the
/// other. The message names the first of them, the faces that meet there, among them copies that
/// the soup has no more, and what would have to go, if that is one of these faces and those that
/// hang together with it. `given`: the mesh as it was before.
void refuse_open_edges(const PolygonSoup& soup, const TriMesh& given);

}  // namespace dupin::healing
