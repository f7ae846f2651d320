#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "dupin/kernel/solid.h"

/// Seeded unions of cylinders in random directions: what rounding breaks most.
namespace dupin::test {

enum class UnionKind {
  equal,     ///< two of the same radius, axes at a right angle: crossing ellipses meet in points
  near,      ///< two almost in line, radii and axes 1e-3 to 1e-9 apart
  rotated,   ///< a branch at a random angle
  far,       ///< two of radius 10 at coordinates up to 1000
  multi,     ///< four through one point
  plant_10,  ///< radius 10 mm at the coordinates of a real plant
  plant_84,  ///< radius 84 mm there
};
inline constexpr UnionKind kDesignKinds[] = {UnionKind::equal, UnionKind::near, UnionKind::rotated,
                                             UnionKind::far, UnionKind::multi};
inline constexpr UnionKind kPlantKinds[] = {UnionKind::plant_10, UnionKind::plant_84};

[[nodiscard]] std::string_view name(UnionKind kind);

/// The cylinders to unite. `segments` is at least 3.
[[nodiscard]] std::vector<Solid> pipes(UnionKind kind, std::uint32_t segments, std::uint32_t seed);

/// So many pipes along x on as many along y, at about 1.7e6, where neighbouring floats are 0.125
/// apart: they lie on each other, or miss or cross each other, by less than that. Their diameter is
/// 60: those along x, whose axes are so far apart, lie beside each other likewise.
[[nodiscard]] std::vector<Solid> resting_pipes(int count, std::uint32_t seed, double apart = 60);

}  // namespace dupin::test
