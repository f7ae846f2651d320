#pragma once

#include <array>
#include <optional>
#include <vector>

#include <gmpxx.h>

#include "dupin/blends/spine.h"

namespace dupin::detail {

using ExactVec3 = std::array<mpq_class, 3>;

/// The number itself. Throws Error{invalid_argument} if it is not finite.
[[nodiscard]] mpq_class exact(double x);
[[nodiscard]] ExactVec3 exact(const Vec3& v);
[[nodiscard]] ExactVec3 operator+(const ExactVec3& a, const ExactVec3& b);
[[nodiscard]] ExactVec3 operator-(const ExactVec3& a, const ExactVec3& b);
[[nodiscard]] ExactVec3 operator*(const mpq_class& s, const ExactVec3& v);
[[nodiscard]] ExactVec3 cross(const ExactVec3& a, const ExactVec3& b);
[[nodiscard]] mpq_class dot(const ExactVec3& a, const ExactVec3& b);

/// A unit normal of the plane that the spine lies in, decided exactly from its coefficients; any
/// normal for a straight spine, none for a spatial one.
[[nodiscard]] std::optional<Vec3> plane_normal(const Spine& spine);

/// The coefficients of y'(t), lowest power first, exactly those of the stored numbers.
[[nodiscard]] std::vector<ExactVec3> velocity(const LineSpine& line);
[[nodiscard]] std::vector<ExactVec3> velocity(const HermiteSpine& hermite);

/// y'(t) of a rational curve, as numerator / weight^2.
struct RationalVelocity {
  std::vector<ExactVec3> numerator;
  std::vector<mpq_class> weight;
};

[[nodiscard]] RationalVelocity velocity(const BezierSpine& bezier);

}  // namespace dupin::detail
