#include "arrangement/facet_order.h"

#include <algorithm>

#include "arrangement/implicit_predicates.h"

namespace dupin::arrangement {
namespace {

// +1 if turning counter-clockwise by less than a half turn leads from `from` to `to`, -1 if turning
// clockwise does, 0 if they are opposite. The front of a sheet that runs forward lies ahead of it.
int ahead(const ArrangementInput& input, const HalfPlane& from, const HalfPlane& to) {
  const Triangle& plane = input.support(from.support);
  const int side = side_of_plane(input.points, plane[0], plane[1], plane[2], to.apex);
  return from.forward ? side : -side;
}

}  // namespace

void order_facets_around_edge(const ArrangementInput& input, std::vector<HalfPlane>& half_planes) {
  const HalfPlane first = half_planes.front();
  const auto half_turns = [&](const HalfPlane& s) {
    const int side = ahead(input, first, s);
    return side > 0 ? 1 : side == 0 ? 2 : 3;
  };
  std::vector<std::pair<int, HalfPlane>> keyed;
  for (const HalfPlane& s : half_planes) {
    keyed.emplace_back(keyed.empty() ? 0 : half_turns(s), s);
  }
  std::sort(keyed.begin(), keyed.end(), [&input](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first
                              : a.first % 2 == 1 && ahead(input, a.second, b.second) > 0;
  });
  for (std::size_t i = 0; i < half_planes.size(); ++i) {
    half_planes[i] = keyed[i].second;
  }
}

}  // namespace dupin::arrangement
