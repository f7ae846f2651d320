#pragma once

#include <string>

#include "dupin/kernel/vec.h"

namespace dupin {

/// What set operations, and all that decides of meshes, compute with: 0, and numbers whose size is
/// in this range. It holds all of binary32, and is so much narrower than binary64 that no product
/// that is decided with overflows: of seven differences of coordinates at most.
inline constexpr double kLeastCoordinate = 1e-60, kGreatestCoordinate = 1e39;

[[nodiscard]] bool is_in_range(double coordinate);
/// Of all three.
[[nodiscard]] bool is_in_range(const Vec3& point);
/// About the first coordinate that is not: "the x coordinate 1e+308, which must be 0 or ...".
[[nodiscard]] std::string range_fault(const Vec3& point);

/// What a file format can hold.
enum class Coordinates { binary64, binary32 };

/// The number of the format nearest to `value`, ties to even; an infinity beyond its range. Not to
/// be written as casts on the spot: GCC 12 drops them where they come in pairs.
[[nodiscard]] double nearest(double value, Coordinates coordinates);
[[nodiscard]] Vec3 nearest(const Vec3& point, Coordinates coordinates);

}  // namespace dupin
