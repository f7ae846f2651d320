#pragma once

#include "dupin/kernel/vec.h"

namespace dupin {

/// What a file format can hold.
enum class Coordinates { binary64, binary32 };

/// The number of the format nearest to `value`, ties to even; an infinity beyond its range. Not to
/// be written as casts on the spot: GCC 12 drops them where they come in pairs.
[[nodiscard]] double nearest(double value, Coordinates coordinates);
[[nodiscard]] Vec3 nearest(const Vec3& point, Coordinates coordinates);

}  // namespace dupin
