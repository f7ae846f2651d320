#pragma once

#include "healing/polygon_soup.h"

namespace dupin::healing {

/// Drops triangles without area, any number on one line, so that no slit opens; returns how many.
///
/// Those that hang together by edges lie on one line. Each proper triangle at such an edge is
/// divided at all of their corners on it, which leaves its area as it is. Lemma: then the edges are
/// as balanced as before. The dropped triangles' own edges, divided at the same points, run along
/// each piece as often one way as the other, as each triangle runs to and fro.
///
/// O(n log n) in the triangles that come in and go out. Throws Error{limit_exceeded} if those that
/// go out are too many to count.
std::size_t drop_degenerate_faces(PolygonSoup& soup);

}  // namespace dupin::healing
