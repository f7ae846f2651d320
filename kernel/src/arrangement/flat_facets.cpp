#include "arrangement/flat_facets.h"

#include <algorithm>

#include "arrangement/points/implicit_predicates.h"
#include "support/blocks.h"

namespace dupin::arrangement {
namespace {

// Pairs of triangles that one task looks at.
constexpr std::size_t kPairs = 256;

bool is_corner_of(const Triangle& corners, PointId id) {
  return std::find(corners.begin(), corners.end(), id) != corners.end();
}

// The corner of the first triangle that is not one of the second.
std::size_t apex(const Triangle& corners, const Triangle& other) {
  std::size_t k = 0;
  while (k < 2 && is_corner_of(other, corners[k])) {
    ++k;
  }
  return k;
}

// The edge of the first triangle at which the second one lies.
Feature edge_between(const Triangle& first, const Triangle& second) {
  return edge_feature((static_cast<int>(apex(first, second)) + 1) % 3);
}

std::uint32_t label_of(const ArrangementInput& input, std::uint32_t triangle) {
  const std::uint32_t operand = input.operand_of(triangle);
  const std::vector<std::uint32_t>& labels = input.operands[operand]->labels;
  return labels.empty() ? 0 : labels[triangle - input.first_triangle[operand]];
}

// No other triangle coincides with it.
bool covers_alone(const ArrangementInput& input, std::uint32_t triangle) {
  return !input.merged[triangle] && !std::ranges::binary_search(input.duplicates, triangle, {},
                                                                &ArrangementInput::Duplicate::kept);
}

// Whether what is between them is longer than their other edges. At most one edge of a triangle is,
// as a length that is rounded upward depends on the edge, but not on who asks.
bool is_longest(const ArrangementInput& input, const FlatFacets::Corners& ring) {
  const auto length = [&](std::size_t i, std::size_t k) {
    const auto [low, high] = std::minmax({ring[i], ring[k]});
    return (input.points.coordinates(high) - input.points.coordinates(low)).squaredNorm();
  };
  const double between = length(1, 3);
  return length(0, 1) < between && length(1, 2) < between && length(2, 3) < between &&
         length(3, 0) < between;
}

bool are_one(const ArrangementInput& input, const TrianglePair& pair) {
  const auto& [t, u] = pair;
  const FlatFacets::Corners ring = joined(input.triangles[t], input.triangles[u]);
  if (!std::ranges::all_of(ring.all(), [&](PointId id) { return input.points.is_double(id); }) ||
      !is_longest(input, ring) || !lie_in_one_plane(input, pair)) {
    return false;
  }
  const Projection projection = projection_of(input.points, input.triangles[t]);
  return std::ranges::all_of(std::array{1U, 3U}, [&](std::size_t i) {
    return turn(input.points, ring[i - 1], ring[i], ring[ring.after(i)], projection.axis) ==
           projection.orientation;
  });
}

}  // namespace

FlatFacets::Corners joined(const Triangle& first, const Triangle& second) {
  const std::size_t k = apex(first, second);
  return {{first[k], first[(k + 1) % 3], second[apex(second, first)], first[(k + 2) % 3]}, 4};
}

bool lie_in_one_plane(const ArrangementInput& input, const TrianglePair& pair) {
  const auto& [t, u] = pair;
  const Triangle &first = input.triangles[t], &second = input.triangles[u];
  return input.operand_of(t) == input.operand_of(u) && label_of(input, t) == label_of(input, u) &&
         covers_alone(input, t) && covers_alone(input, u) &&
         side_of_plane(input.points, first[0], first[1], first[2], second[apex(second, first)]) ==
             0;
}

FlatFacets::FlatFacets(const ArrangementInput& input, const std::vector<TrianglePair>& candidates) {
  const std::vector<std::uint32_t> facets = support::indices_where(
      candidates.size(),
      [&](std::size_t i) {
        const UpwardRounding rounding;
        return are_one(input, candidates[i]);
      },
      kPairs);
  if (facets.empty()) {
    return;
  }
  mates_.resize(input.triangles.size());
  support::fill_all(mates_, {kNone, kInside});
  for (const std::uint32_t i : facets) {
    const auto& [t, u] = candidates[i];
    mates_[t] = {u, edge_between(input.triangles[t], input.triangles[u])};
    mates_[u] = {t, edge_between(input.triangles[u], input.triangles[t])};
  }
}

bool FlatFacets::is_joint(const TriangleIntersection& e, std::size_t end) const {
  const auto goes_on = [&](std::uint32_t triangle, Feature TriangleIntersection::End::*feature) {
    const Feature here = e.ends[end].*feature;
    return is_inside(triangle, here) ||
           (is_edge(here) &&
            (e.coplanar || (e.kind == TriangleIntersection::Kind::segment &&
                            common_edge(e.ends[0].*feature, e.ends[1].*feature) == here)));
  };
  return (is_inner_edge(e.first, e.ends[end].on_first) ||
          is_inner_edge(e.second, e.ends[end].on_second)) &&
         goes_on(e.first, &TriangleIntersection::End::on_first) &&
         goes_on(e.second, &TriangleIntersection::End::on_second);
}

FlatFacets::Corners FlatFacets::corners(const ArrangementInput& input,
                                        std::uint32_t triangle) const {
  const Triangle& own = input.triangles[triangle];
  return mate(triangle) == kNone ? Corners{{own[0], own[1], own[2], kNone}, 3}
                                 : joined(own, input.triangles[mate(triangle)]);
}

}  // namespace dupin::arrangement
