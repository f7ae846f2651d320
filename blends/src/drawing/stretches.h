#pragma once

#include <vector>

#include "dupin/kernel/hidden_lines.h"

namespace dupin::drawing {

/// Of [0, end], what the stretches leave; these are ascending and apart.
[[nodiscard]] std::vector<Stretch> complement(const std::vector<Stretch>& stretches, double end);

/// What is in both.
[[nodiscard]] std::vector<Stretch> intersection(const std::vector<Stretch>& a,
                                                const std::vector<Stretch>& b);

/// That part of a polyline.
[[nodiscard]] std::vector<Vec3> cut(const std::vector<Vec3>& line, const Stretch& stretch);

}  // namespace dupin::drawing
