#pragma once

#include <span>
#include <vector>

#include "dupin/blends/tessellation.h"
#include "dupin/kernel/ring.h"

namespace dupin::tessellation {

/// The face of a straight tube, a right cylinder or cone between two circles on one axis, as far as
/// curves leave it. Curves are closed polygons that neither cross nor pass a ring that is kept;
/// they may have corners in common.
struct TrimmedFace {
  Ring start, end;  ///< normals pointing out of the tube
  std::vector<std::vector<Vec3>> curves;
  bool keeps_start = true, keeps_end = true;  ///< whether the face reaches that ring
};

/// Its triangles, counter-clockwise from outside; corners are those of the rings' polygons, as far
/// as they are kept, and of the curves, and others on the face: first the start's as
/// sample(flipped(start), sampling), last the end's as sample(end, sampling), bitwise.
///
/// Where there are curves, a constrained Delaunay triangulation of the unrolled face, with points
/// so that no triangle is a sliver (`refined_region`); between them, bands of triangles from ring
/// to ring that are at most 50 times as long as wide, or 8 bands on a longer face. Every triangle
/// is within R (1 - cos(angle / 2)) of the face, `angle` being what it spans about the axis:
/// `error_bound`.
///
/// Throws Error{self_intersecting} where curves cross, pass a ring that is kept, or lie one inside
/// another.
[[nodiscard]] Tessellation trimmed_face(const TrimmedFace& face, const RingSampling& sampling);

/// How many triangles trimmed_face() makes, about, of which curves may be told by a few points
/// each. Takes as long for any number. Boundaries that are finer than the sampling ask for more.
[[nodiscard]] double expected_triangles(const TrimmedFace& face, const RingSampling& sampling);

}  // namespace dupin::tessellation
