#pragma once

#include <string>

#include "dupin/kernel/vec.h"

namespace dupin::support {

/// The shortest decimal that reads back to the same double.
[[nodiscard]] std::string text(double value);
/// "(x, y, z)".
[[nodiscard]] std::string text(const Vec3& point);

}  // namespace dupin::support
