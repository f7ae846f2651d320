#pragma once

#include "dupin/kernel/mesh.h"
#include "meshing/curve_points.h"
#include "meshing/delaunay_refinement.h"

namespace dupin::meshing {

/// A power of two that is about the extent of the mesh, so that lengths in it are about 1: what is
/// scaled by it is so exactly. For generators that compare lengths with numbers of their own, or
/// multiply many of them.
[[nodiscard]] double unit_for(const TriMesh& mesh);

/// All lengths, from 1 to `unit`.
[[nodiscard]] CurvePoints in_unit(CurvePoints balls, double unit);
[[nodiscard]] Refinement in_unit(Refinement wanted, double unit);

}  // namespace dupin::meshing
