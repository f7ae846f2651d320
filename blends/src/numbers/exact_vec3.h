#pragma once

#include <array>

#include <gmpxx.h>

#include "dupin/kernel/vec.h"

namespace dupin::numbers {

/// A vector of R^3 with rational coordinates.
struct ExactVec3 : std::array<mpq_class, 3> {};

/// The number itself. Throws Error{invalid_argument} if it is not finite.
[[nodiscard]] mpq_class exact(double x);
[[nodiscard]] ExactVec3 exact(const Vec3& v);
[[nodiscard]] ExactVec3 operator+(const ExactVec3& a, const ExactVec3& b);
[[nodiscard]] ExactVec3 operator-(const ExactVec3& a, const ExactVec3& b);
[[nodiscard]] ExactVec3 operator*(const mpq_class& s, const ExactVec3& v);
[[nodiscard]] ExactVec3 cross(const ExactVec3& a, const ExactVec3& b);
[[nodiscard]] mpq_class dot(const ExactVec3& a, const ExactVec3& b);

}  // namespace dupin::numbers
