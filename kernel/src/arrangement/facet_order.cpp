#include "arrangement/facet_order.h"

#include "arrangement/implicit_predicates.h"
#include "mesh/radial_order.h"

namespace dupin::arrangement {
namespace {

// +1 if turning counter-clockwise by less than a half turn leads from `from` to `to`, -1 if turning
// clockwise does, 0 if they are opposite. The front of one that runs forward lies ahead of it.
int ahead(const ArrangementInput& input, const HalfPlane& from, const HalfPlane& to) {
  const Triangle& plane = input.support(from.support);
  const int side = side_of_plane(input.points, plane[0], plane[1], plane[2], to.apex);
  return from.forward ? side : -side;
}

}  // namespace

void order_facets_around_edge(const ArrangementInput& input, std::vector<HalfPlane>& half_planes) {
  mesh::sort_around_edge(
      half_planes,
      [&input](const HalfPlane& from, const HalfPlane& to) { return ahead(input, from, to); },
      [](const HalfPlane&, const HalfPlane&) { return true; });
}

}  // namespace dupin::arrangement
