#pragma once

#include <cstdint>

#include "dupin/blends/part_surface.h"
#include "dupin/blends/tessellation.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/ring.h"

namespace dupin {

/// The segments around that the tolerance asks of a part alone, at least 8, when points are snapped
/// to a grid of this spacing. Throws Error{invalid_argument} if the tolerance leaves no room for
/// the snapping.
[[nodiscard]] std::uint32_t segments_for(const Chain& chain, double tolerance, double grid = 0);
[[nodiscard]] std::uint32_t segments_for(const Sphere& sphere, double tolerance, double grid = 0);

/// The tube without end discs: bands + 1 polygons of sampling.segments points each, one after the
/// other. The first is sample(flipped(ring), sampling) of the ring at the start, the last that of
/// the ring at the end, up to the index it starts at, bitwise. Triangles are counter-clockwise from
/// outside. Polygons of elliptic tubes follow the ellipses' parameter.
///
/// Proved, not measured: a triangle is nowhere further from the surface than its parameter legs dt
/// and du allow by the bounds of the second derivatives. If the segments are too few for the
/// tolerance, there are as many bands as suit the segments, and `error_bound` says how far it is.
///
/// The meshes of several pieces are joined where these meet, in the polygon of their ring. Cyclide
/// pieces that meet smoothly are swept together, their joints being rows of points. A closed
/// chain's last row is its first one.
///
/// A hollow chain is closed: outer skin, inner skin inside out, and the two conical rims, which the
/// labels tell apart (0: skins, 1: start, 2: end).
///
/// With spherical joints, one mesh of several: the pieces, closed but for the chain's ends, and the
/// sectors of the joints' balls that the kneecaps bound. They share no points, but have copies of
/// the same where they meet, and cover parts of each other; their union is the chain. Of a hollow
/// one those of the inner skin are inside out, and their union is to be taken from that of the
/// others; all are closed. Circles apart by less than a sixteenth of the tolerance count as one.
///
/// Throws Error{irregular_surface}, and Error{invalid_argument} for a tolerance that is too small
/// and for a wall of other pieces than cyclides.
[[nodiscard]] Tessellation tessellate(const Chain& chain, const RingSampling& sampling,
                                      const TessellationOptions& options = {});

/// A closed sphere of sampling.segments meridians about the z axis.
[[nodiscard]] Tessellation tessellate(const Sphere& sphere, const RingSampling& sampling);

/// The smallest angle of a mesh's triangles, in radians; 0 if one has none.
[[nodiscard]] double smallest_angle(const TriMesh& mesh);

/// The flat end: sample(ring, sampling) with the triangles between these points only, normals along
/// the ring's. The disc of flipped(ring) has the same triangles the other way round, so that discs
/// that meet cancel exactly.
[[nodiscard]] TriMesh end_cap_mesh(const Ring& ring, const RingSampling& sampling);

}  // namespace dupin
