#pragma once

#include <optional>
#include <vector>

#include <gmpxx.h>

#include "dupin/blends/spine.h"
#include "numbers/exact_vec3.h"

namespace dupin::curves {

/// A unit normal of the plane that the spine lies in, decided exactly from its coefficients; any
/// normal for a straight spine, none for a spatial one.
[[nodiscard]] std::optional<Vec3> plane_normal(const Spine& spine);

/// The coefficients of y'(t), lowest power first, exactly those of the stored numbers.
[[nodiscard]] std::vector<numbers::ExactVec3> velocity(const LineSpine& line);
[[nodiscard]] std::vector<numbers::ExactVec3> velocity(const HermiteSpine& hermite);

/// y'(t) of a rational curve, as numerator / weight^2.
struct RationalVelocity {
  std::vector<numbers::ExactVec3> numerator;
  std::vector<mpq_class> weight;
};

[[nodiscard]] RationalVelocity velocity(const BezierSpine& bezier);

}  // namespace dupin::curves
