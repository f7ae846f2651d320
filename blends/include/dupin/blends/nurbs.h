#pragma once

#include "dupin/blends/nurbs_surface.h"
#include "dupin/blends/part_surface.h"

namespace dupin {

/// Exact, as the papers' surfaces are rational: cylinders, cones and elbows of any section,
/// spheres, straight blends with polynomial radii, rational ringed surfaces (bidegree (9, 2) or (5,
/// 2)) and pieces of cyclides (2, 2); of a chain with kneecaps the pieces and the whole spheres at
/// the joints, which trim each other.
///
/// Others have no exact form, because |y'| is irrational: cyclic blends, splines, elliptic blends.
/// They are lofted through their own circles by cubics that share the tangent planes of the part
/// there, refined until the bound, by interval arithmetic, is at most `tolerance`. Throws
/// Error{limit_exceeded} if more than 4096 cubics are needed.
[[nodiscard]] NurbsForm nurbs(const PartSurface& surface, double tolerance);

}  // namespace dupin
