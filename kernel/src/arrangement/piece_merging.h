#pragma once

#include "arrangement/input.h"
#include "arrangement/non_manifold_vertices.h"

namespace dupin::arrangement {

/// Triangulates anew what of each triangle is kept, so that points go which only the way there has
/// left: those inside of it, and those on a straight edge to what is kept of another. Pieces belong
/// to the same triangle where operands' sources say so, and are connected.
///
/// The surface stays the same set of points. What goes is found from the edges that separate pieces
/// of different triangles ("borders"), looked at from all sides at once:
/// - A point without borders lies inside of the pieces of one triangle, which are all the surface
///   around it.
/// - A point with two borders, each between two triangles, has the pieces of two triangles around
///   it and nothing else. If their planes differ, both borders lie on the line that these share.
/// - Any other point, and any at which the surface touches itself, has more borders, or one with
///   more than two triangles. It stays, for all that have it.
/// So the pieces on both sides of a border lose the same points of it, and the surface stays
/// closed. Needs UpwardRounding.
[[nodiscard]] support::BulkVector<OutputTriangle> merge_pieces(
    const ArrangementInput& input, const support::BulkVector<OutputTriangle>& kept);

}  // namespace dupin::arrangement
