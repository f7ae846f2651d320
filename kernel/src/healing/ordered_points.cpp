#include "healing/ordered_points.h"

#include <algorithm>
#include <tuple>

#include "support/sequences.h"

namespace dupin::healing {

std::vector<std::uint32_t> places_by_coordinates(std::span<const Vec3> points) {
  std::vector<std::uint32_t> order = support::numbers_below(points.size());
  std::ranges::sort(order, {}, [&](std::uint32_t i) {
    const Vec3& p = points[i];
    return std::tuple(p.x(), p.y(), p.z(), i);
  });
  std::vector<std::uint32_t> places(order.size());
  for (std::uint32_t place = 0; place < order.size(); ++place) {
    places[order[place]] = place;
  }
  return places;
}

}  // namespace dupin::healing
