#include "arrangement/coplanar_intersection.h"

#include <algorithm>

#include "arrangement/implicit_predicates.h"

namespace dupin::arrangement {
namespace {

// sides[e][c]: the side of corner c of one triangle as seen from edge e of the other, +1 within.
using SideTable = std::array<std::array<int, 3>, 3>;

SideTable sides_of_edges(const PointTable& points, const Triangle& edges, const Triangle& corners,
                         const Projection& projection) {
  SideTable sides{};
  for (std::size_t e = 0; e < 3; ++e) {
    for (std::size_t c = 0; c < 3; ++c) {
      sides[e][c] = projection.orientation *
                    turn(points, edges[e], edges[(e + 1) % 3], corners[c], projection.axis);
    }
  }
  return sides;
}

// Some edge has the whole other triangle outside it or on it.
bool separated(const SideTable& sides) {
  return std::any_of(sides.begin(), sides.end(),
                     [](const auto& s) { return s[0] <= 0 && s[1] <= 0 && s[2] <= 0; });
}

bool apart(const SideTable& sides) {
  return std::any_of(sides.begin(), sides.end(),
                     [](const auto& s) { return s[0] < 0 && s[1] < 0 && s[2] < 0; });
}

struct Located {
  bool within = false;
  Feature feature = kInside;
};

Located locate(const SideTable& sides, std::size_t corner) {
  std::array<bool, 3> on{};
  for (std::size_t e = 0; e < 3; ++e) {
    if (sides[e][corner] < 0) {
      return {};
    }
    on[e] = sides[e][corner] == 0;
  }
  for (std::size_t e = 0; e < 3; ++e) {
    if (on[e] && on[(e + 2) % 3]) {
      return {true, static_cast<Feature>(e)};
    }
  }
  for (int e = 0; e < 3; ++e) {
    if (on[static_cast<std::size_t>(e)]) {
      return {true, edge_feature(e)};
    }
  }
  return {true, kInside};
}

}  // namespace

void intersect_coplanar(const ArrangementInput& input, std::uint32_t first, std::uint32_t second,
                        std::vector<TriangleIntersection>& intersections) {
  const PointTable& points = input.points;
  const Triangle &a = input.triangles[first], &b = input.triangles[second];
  const Projection projection = projection_of(points, input.support(first));
  const Projection other{projection.axis,
                         turn(points, input.support(second)[0], input.support(second)[1],
                              input.support(second)[2], projection.axis)};
  const SideTable b_from_a = sides_of_edges(points, a, b, projection);
  if (apart(b_from_a)) {
    return;
  }
  const SideTable a_from_b = sides_of_edges(points, b, a, other);
  if (apart(a_from_b)) {
    return;
  }
  const auto add = [&](TriangleIntersection::Kind kind, Feature on_first, Feature on_second) {
    const TriangleIntersection::End end{on_first, on_second};
    intersections.push_back(
        {first, second, kind, true, static_cast<std::uint8_t>(projection.axis), {end, end}});
  };
  for (std::size_t c = 0; c < 3; ++c) {
    const Located a_corner = locate(a_from_b, c), b_corner = locate(b_from_a, c);
    if (a_corner.within && !is_corner(a_corner.feature)) {
      add(TriangleIntersection::Kind::point, static_cast<Feature>(c), a_corner.feature);
    }
    if (b_corner.within && !is_corner(b_corner.feature)) {
      add(TriangleIntersection::Kind::point, b_corner.feature, static_cast<Feature>(c));
    }
  }
  for (std::size_t e = 0; e < 3; ++e) {
    for (std::size_t f = 0; f < 3; ++f) {
      if (b_from_a[e][f] * b_from_a[e][(f + 1) % 3] < 0 &&
          a_from_b[f][e] * a_from_b[f][(e + 1) % 3] < 0) {
        add(TriangleIntersection::Kind::point, edge_feature(static_cast<int>(e)),
            edge_feature(static_cast<int>(f)));
      }
    }
  }
  if (!separated(b_from_a) && !separated(a_from_b)) {
    add(TriangleIntersection::Kind::overlap, kInside, kInside);
  }
}

}  // namespace dupin::arrangement
