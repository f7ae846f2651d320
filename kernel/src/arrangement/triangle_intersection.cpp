#include "arrangement/triangle_intersection.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "arrangement/points/implicit_predicates.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "support/sort_by_key.h"

namespace dupin::arrangement {
namespace {

using Signs = std::array<int, 3>;

// The line common to both planes runs in direction D = n x u, n the normal of the first triangle
// and u pointing within its plane to the front of the second. An end of a triangle's interval on
// that line is where a segment from `plus` (in front of the other plane or on it) to `minus`
// (behind or on) meets it.
struct IntervalEnd {
  Feature feature = kInside;
  PointId plus = kNone, minus = kNone;
};

struct IntervalOnLine {
  IntervalEnd low, high;
  Feature between = kInside;  // feature of points strictly between the ends
};

bool one_sided(const Signs& s) { return s[0] == s[1] && s[1] == s[2] && s[0] != 0; }

bool lies_in(const PlaneSides& plane, const Triangle& support) {
  return std::all_of(support.begin(), support.end(), [&](PointId p) { return plane.of(p) == 0; });
}

// Of a triangle in the same plane, its support tells so sooner than implicit corners.
Signs sides(const ArrangementInput& input, std::uint32_t triangle, std::uint32_t plane) {
  const Triangle& corners = input.triangles[triangle];
  const Triangle& others = input.triangles[plane];
  const auto& [a, b, c] = input.support(plane);
  const PlaneSides sides(input.points, a, b, c);
  bool is_support_in_doubt = true;
  Signs s{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::find(others.begin(), others.end(), corners[k]) != others.end()) {
      continue;
    }
    if (!input.points.is_double(corners[k])) {
      s[k] = sides.of_enclosed(corners[k]);
      if (s[k] == 0 && std::exchange(is_support_in_doubt, false) &&
          lies_in(sides, input.support(triangle))) {
        return {0, 0, 0};
      }
    }
    if (s[k] == 0) {
      s[k] = sides.of(corners[k]);
    }
  }
  return s;
}

IntervalEnd corner_end(const Triangle& corners, const Signs& s, std::size_t k) {
  std::size_t off = 0;  // a corner off the line, which exists as the planes differ
  while (s[off] == 0) {
    ++off;
  }
  return s[off] > 0 ? IntervalEnd{static_cast<Feature>(k), corners[off], corners[k]}
                    : IntervalEnd{static_cast<Feature>(k), corners[k], corners[off]};
}

// Walking counter-clockwise, the boundary of the first triangle comes down from the front of the
// other plane at the high end; that of the second, for which D has the opposite sense, at the low.
IntervalOnLine interval(const Triangle& corners, const Signs& s, bool is_first) {
  IntervalOnLine result;
  const auto set = [&](int change, const IntervalEnd& end) {
    if (change >= 0) {
      (is_first ? result.high : result.low) = end;
    }
    if (change <= 0) {
      (is_first ? result.low : result.high) = end;
    }
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3, previous = (k + 2) % 3;
    if (s[k] == 0) {
      set(s[previous] - s[next], corner_end(corners, s, k));
      if (s[next] == 0) {
        result.between = edge_feature(static_cast<int>(k));
      }
    } else if (s[k] * s[next] < 0) {
      const Feature edge = edge_feature(static_cast<int>(k));
      set(s[k], s[k] > 0 ? IntervalEnd{edge, corners[k], corners[next]}
                         : IntervalEnd{edge, corners[next], corners[k]});
    }
  }
  return result;
}

// The sign of y - x along D; x ends the first triangle's interval, y the second's.
int order(const PointTable& points, const IntervalEnd& x, const IntervalEnd& y) {
  return side_of_plane(points, x.plus, x.minus, y.plus, y.minus);
}

void report(std::uint32_t first, std::uint32_t second, TriangleIntersection::End low,
            TriangleIntersection::End high, bool is_point,
            std::vector<TriangleIntersection>& intersections) {
  if (is_point && is_corner(low.on_first) && is_corner(low.on_second)) {
    return;
  }
  intersections.push_back(
      {first,
       second,
       is_point ? TriangleIntersection::Kind::point : TriangleIntersection::Kind::segment,
       false,
       0,
       {low, high}});
}

void meet_across(const ArrangementInput& input, std::uint32_t first, std::uint32_t second,
                 const Signs& first_sides, const Signs& second_sides,
                 std::vector<TriangleIntersection>& intersections) {
  const IntervalOnLine a = interval(input.triangles[first], first_sides, true);
  const IntervalOnLine b = interval(input.triangles[second], second_sides, false);
  const PointTable& points = input.points;
  const int a_high_to_b_low = order(points, a.high, b.low);
  if (a_high_to_b_low > 0) {
    return;
  }
  const int a_low_to_b_high = order(points, a.low, b.high);
  if (a_low_to_b_high < 0) {
    return;
  }
  if (a_high_to_b_low == 0) {
    const TriangleIntersection::End end{a.high.feature, b.low.feature};
    return report(first, second, end, end, true, intersections);
  }
  if (a_low_to_b_high == 0) {
    const TriangleIntersection::End end{a.low.feature, b.high.feature};
    return report(first, second, end, end, true, intersections);
  }
  const int low = order(points, a.low, b.low), high = order(points, a.high, b.high);
  const TriangleIntersection::End from{low > 0 ? a.between : a.low.feature,
                                       low < 0 ? b.between : b.low.feature, low <= 0};
  const TriangleIntersection::End to{high < 0 ? a.between : a.high.feature,
                                     high > 0 ? b.between : b.high.feature, high >= 0};
  const bool is_point = a.low.feature == a.high.feature || b.low.feature == b.high.feature;
  const bool is_common_edge = is_corner(from.on_first) && is_corner(from.on_second) &&
                              is_corner(to.on_first) && is_corner(to.on_second);
  if (!is_common_edge) {
    report(first, second, from, to, is_point, intersections);
  }
}

// sides[e][c]: the side of corner c of one triangle as seen from edge e of the other, +1 within.
using SideTable = std::array<std::array<int, 3>, 3>;

// Corners, projected.
struct Projected {
  Projected(const PointTable& points, const Triangle& corners, int axis) : ids(corners) {
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] = {points.interval(ids[k], (axis + 1) % 3), points.interval(ids[k], (axis + 2) % 3)};
    }
  }
  const Triangle& ids;
  std::array<std::array<Interval, 2>, 3> at;
};

SideTable sides_of_edges(const PointTable& points, const Projected& edges, const Projected& corners,
                         const Projection& projection) {
  SideTable sides{};
  for (std::size_t e = 0; e < 3; ++e) {
    const std::size_t next = (e + 1) % 3;
    const auto& [x, y] = edges.at[e];
    const Interval u = edges.at[next][0] - x, v = edges.at[next][1] - y;
    for (std::size_t c = 0; c < 3; ++c) {
      const FilteredSign filtered =
          sign_of(u * (corners.at[c][1] - y) - v * (corners.at[c][0] - x));
      sides[e][c] =
          projection.orientation * (filtered.certain ? filtered.sign
                                                     : turn(points, edges.ids[e], edges.ids[next],
                                                            corners.ids[c], projection.axis));
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

// Pairs of edges that cross.
template <class Visit>
void for_each_crossing(const SideTable& b_from_a, const SideTable& a_from_b, const Visit& visit) {
  for (std::size_t e = 0; e < 3; ++e) {
    for (std::size_t f = 0; f < 3; ++f) {
      if (b_from_a[e][f] * b_from_a[e][(f + 1) % 3] < 0 &&
          a_from_b[f][e] * a_from_b[f][(e + 1) % 3] < 0) {
        visit(e, f);
      }
    }
  }
}

}  // namespace

// Corners on or in the other triangle, crossings of edges, and whether there is a common area.
void intersect_in_plane(const ArrangementInput& input, std::uint32_t first, std::uint32_t second,
                        const LeavesOut& leaves_out,
                        std::vector<TriangleIntersection>& intersections) {
  const PointTable& points = input.points;
  const Projection projection = projection_of(points, input.support(first));
  const Projected a(points, input.triangles[first], projection.axis),
      b(points, input.triangles[second], projection.axis);
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
  for_each_crossing(b_from_a, a_from_b, [&](std::size_t e, std::size_t f) {
    if (!leaves_out || !leaves_out(e, f)) {
      add(TriangleIntersection::Kind::point, edge_feature(static_cast<int>(e)),
          edge_feature(static_cast<int>(f)));
    }
  });
  if (!separated(b_from_a) && !separated(a_from_b)) {
    add(TriangleIntersection::Kind::overlap, kInside, kInside);
  }
}

Feature common_edge(Feature a, Feature b) {
  for (Feature edge = 3; edge < kInside; ++edge) {
    const auto on_edge = [edge](Feature f) {
      return f == edge || f == edge - 3 || f == (edge - 2) % 3;
    };
    if (on_edge(a) && on_edge(b)) {
      return edge;
    }
  }
  return kInside;
}

void intersect(const ArrangementInput& input, std::uint32_t first, std::uint32_t second,
               std::vector<TriangleIntersection>& intersections) {
  if (!intersect_across(input, first, second, intersections)) {
    intersect_in_plane(input, first, second, {}, intersections);
  }
}

bool intersect_across(const ArrangementInput& input, std::uint32_t first, std::uint32_t second,
                      std::vector<TriangleIntersection>& intersections) {
  const Signs first_sides = sides(input, first, second);
  if (first_sides == Signs{0, 0, 0}) {
    return false;
  }
  if (one_sided(first_sides)) {
    return true;
  }
  const Signs second_sides = sides(input, second, first);
  if (!one_sided(second_sides)) {
    meet_across(input, first, second, first_sides, second_sides, intersections);
  }
  return true;
}

Projection projection_of(const PointTable& points, const Triangle& support) {
  const Vec3 a = points.approximation(support[0]);
  const Vec3 normal =
      (points.approximation(support[1]) - a).cross(points.approximation(support[2]) - a);
  std::array<int, 3> axes{0, 1, 2};
  support::sort_run(std::span<int>(axes),
                    [&](int i, int j) { return std::abs(normal[i]) > std::abs(normal[j]); });
  for (const int axis : axes) {
    const int orientation = turn(points, support[0], support[1], support[2], axis);
    if (orientation != 0) {
      return {axis, orientation};
    }
  }
  throw Error(Errc::internal,
              "internal error, please report it: the arrangement has a triangle "
              "without area at " +
                  decimal(a));
}

}  // namespace dupin::arrangement
