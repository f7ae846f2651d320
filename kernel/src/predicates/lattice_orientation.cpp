#include "predicates/lattice_orientation.h"

#include <array>

#include "exact/lattice_steps.h"

namespace dupin::predicates {

std::optional<int> lattice_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  for (int k = 0; k < 3; ++k) {
    if (a[k] == b[k] && a[k] == c[k] && a[k] == p[k]) {
      return 0;  // in a plane across an axis, as many are, whatever the others
    }
  }
  std::array<std::array<std::int64_t, 3>, 3> from_a;  // b, c and p
  for (int k = 0; k < 3; ++k) {
    const auto axis = exact::lattice_steps(std::array{a[k], b[k], c[k], p[k]});
    if (!axis.are_whole) {
      return std::nullopt;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      from_a[i][static_cast<std::size_t>(k)] = axis.steps[i + 1] - axis.steps[0];
    }
  }
  const auto [high, low] = exact::dot(exact::cross(from_a[0], from_a[1]), from_a[2]);
  if (high != 0) {
    return high > 0 ? 1 : -1;
  }
  return low != 0 ? 1 : 0;
}

}  // namespace dupin::predicates
