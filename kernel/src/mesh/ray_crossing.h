#pragma once

#include <array>
#include <cstddef>

namespace dupin::mesh {

/// How a ray along an axis, with `direction` +1 or -1, crosses a triangle: +1 if it enters the back
/// and leaves through the front, -1 if the other way round, 0 if it misses. The start counts as
/// moved by an infinitesimal along the next axis, and by a smaller one along the third
/// [EM90]: so no edge or corner is met, and a triangle parallel to the ray never.
///
/// `triangle` answers for the start and corners 0 to 2, exactly: is_above(i), whether the corner is
/// beyond the start along the third axis; turn(i, j), +1 if the start lies left of the line from
/// one corner to another, seen against the axis; side(), +1 if it lies in front of the plane.
template <class TriangleAndStart>
[[nodiscard]] int ray_crossing(const TriangleAndStart& triangle, int direction) {
  const std::array<bool, 3> above{triangle.is_above(0), triangle.is_above(1), triangle.is_above(2)};
  if (above[0] == above[1] && above[1] == above[2]) {
    return 0;
  }
  int winding = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (above[i] != above[j]) {
      const int side = triangle.turn(i, j);
      winding += above[j] && side > 0 ? 1 : above[i] && side < 0 ? -1 : 0;
    }
  }
  if (winding == 0) {
    return 0;
  }
  const int slope = winding * direction;
  return triangle.side() * slope < 0 ? slope : 0;
}

}  // namespace dupin::mesh
