#pragma once

#include <vector>

#include "dupin/blends/radius_law.h"
#include "dupin/blends/spine.h"
#include "surfaces/nurbs_rows.h"

namespace dupin::surfaces {

/// Rows of control points with their degree; none where there is no exact form.
struct ExactRows {
  std::vector<NurbsRow> rows;
  int degree = 1;
};

/// Of the circles or ellipses with these semi-axes along a spine, the first beginning along `axis`:
/// a straight spine with polynomial radii, or an arc with constant ones.
[[nodiscard]] ExactRows exact_rows(const Spine& spine, const RadiusLaw& first,
                                   const RadiusLaw& second, const Vec3& axis);

}  // namespace dupin::surfaces
