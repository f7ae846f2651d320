#include "arrangement/flat_sheets.h"

#include <algorithm>

#include "arrangement/flat_facets.h"
#include "arrangement/points/implicit_predicates.h"
#include "arrangement/triangle_intersection.h"

namespace dupin::arrangement {

// In one plane, and on both sides of the edge between them.
bool are_one_sheet(const ArrangementInput& input, const TrianglePair& pair) {
  if (!lie_in_one_plane(input, pair)) {
    return false;
  }
  const FlatFacets::Corners ring =
      joined(input.triangles[pair.first], input.triangles[pair.second]);
  const int axis = projection_of(input.points, input.support(pair.first)).axis;
  return turn(input.points, ring[1], ring[3], ring[0], axis) *
             turn(input.points, ring[1], ring[3], ring[2], axis) <
         0;
}

FlatSheets::FlatSheets(const ArrangementInput& input, const std::vector<TrianglePair>& candidates) {
  const UpwardRounding rounding;
  for (const TrianglePair& pair : candidates) {
    if (are_one_sheet(input, pair)) {
      const FlatFacets::Corners ring =
          joined(input.triangles[pair.first], input.triangles[pair.second]);
      edges_.push_back({edge_key(ring[1], ring[3]), pair});
    }
  }
  std::ranges::sort(edges_, {}, &Inner::edge);
}

const TrianglePair* FlatSheets::at(EdgeKey edge) const {
  const auto found = std::ranges::lower_bound(edges_, edge, {}, &Inner::edge);
  return found != edges_.end() && found->edge == edge ? &found->sides : nullptr;
}

}  // namespace dupin::arrangement
