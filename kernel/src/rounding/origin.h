#pragma once

#include <span>

#include "dupin/kernel/rounding.h"

namespace dupin::rounding {

/// The length of the longest side of the box around the points.
[[nodiscard]] double extent(std::span<const Vec3> points);

/// The place that becomes (0, 0, 0): the origin for no points.
[[nodiscard]] Vec3 chosen_origin(const Origin& origin, std::span<const Vec3> points);

}  // namespace dupin::rounding
