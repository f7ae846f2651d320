#include "arrangement/flat_sheets.h"

#include <algorithm>
#include <optional>

#include "arrangement/flat_facets.h"
#include "arrangement/points/implicit_predicates.h"
#include "arrangement/triangle_intersection.h"

namespace dupin::arrangement {
namespace {

// The edge between them, if they lie on both sides of it.
std::optional<EdgeKey> edge_inside(const ArrangementInput& input, const TrianglePair& pair) {
  const Triangle &first = input.triangles[pair.first], &second = input.triangles[pair.second];
  const auto is_shared = [](const Triangle& other) {
    return [&other](PointId id) { return std::ranges::find(other, id) != other.end(); };
  };
  const auto apex = std::ranges::find_if_not(first, is_shared(second));
  const auto other = std::ranges::find_if_not(second, is_shared(first));
  if (apex == first.end() || other == second.end() || !lie_in_one_plane(input, pair)) {
    return std::nullopt;
  }
  const auto i = static_cast<std::size_t>(apex - first.begin());
  const PointId from = first[(i + 1) % 3], to = first[(i + 2) % 3];
  const int axis = projection_of(input.points, input.support(pair.first)).axis;
  return turn(input.points, from, to, *apex, axis) * turn(input.points, from, to, *other, axis) < 0
             ? std::optional(edge_key(from, to))
             : std::nullopt;
}

}  // namespace

FlatSheets::FlatSheets(const ArrangementInput& input, const std::vector<TrianglePair>& candidates) {
  if (std::ranges::any_of(input.operand_pairs, [](const auto& p) { return p[0] == p[1]; })) {
    return;
  }
  const UpwardRounding rounding;
  for (const TrianglePair& pair : candidates) {
    if (const auto edge = edge_inside(input, pair)) {
      edges_.push_back({*edge, pair});
    }
  }
  std::ranges::sort(edges_, {}, &Inner::edge);
}

const TrianglePair* FlatSheets::at(EdgeKey edge) const {
  const auto found = std::ranges::lower_bound(edges_, edge, {}, &Inner::edge);
  return found != edges_.end() && found->edge == edge ? &found->sides : nullptr;
}

}  // namespace dupin::arrangement
