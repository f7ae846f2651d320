#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checking/projected_contours.h"

namespace dupin::checking {
namespace {

using testing::IsEmpty;
using testing::Not;

struct Drawing {
  std::vector<Vec3> points;
  std::vector<DirectedEdge> edges;

  /// A closed polygon through places seen along `axis`, its points at any height.
  void add(const std::vector<std::array<double, 2>>& places, int axis = 2) {
    const auto first = static_cast<std::uint32_t>(points.size());
    const auto count = static_cast<std::uint32_t>(places.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      Vec3 point;
      point[(axis + 1) % 3] = places[i][0];
      point[(axis + 2) % 3] = places[i][1];
      point[axis] = 7.0 * i * (i % 3);
      points.push_back(point);
      edges.push_back({first + i, first + (i + 1) % count});
    }
  }
  [[nodiscard]] std::vector<std::uint32_t> conflicts(int turn = 1, int axis = 2) const {
    return region_conflicts(points, edges, axis, turn);
  }
};

using Places = std::vector<std::array<double, 2>>;

Places square(double x, double y, double size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

Places reversed(Places places) {
  std::ranges::reverse(places);
  return places;
}

Drawing drawing(const std::vector<Places>& curves) {
  Drawing result;
  for (const Places& curve : curves) {
    result.add(curve);
  }
  return result;
}

TEST(RegionConflicts, of_one_curve_are_none) {
  for (int axis = 0; axis < 3; ++axis) {
    Drawing one;
    one.add(square(1, 2, 3), axis);
    EXPECT_THAT(one.conflicts(1, axis), IsEmpty());
  }
  Places star;
  for (int i = 0; i < 1000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 1000, radius = i % 2 == 0 ? 1 : 0.3;
    star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  EXPECT_THAT(drawing({star}).conflicts(), IsEmpty());
  EXPECT_THAT(drawing({star}).conflicts(-1), Not(IsEmpty()));
  EXPECT_THAT(drawing({reversed(star)}).conflicts(-1), IsEmpty());
}

TEST(RegionConflicts, depend_on_how_curves_lie_in_each_other) {
  const Places outer = square(0, 0, 9), inner = square(2, 2, 4), innermost = square(3, 3, 1),
               beside = square(20, 0, 9);
  EXPECT_THAT(drawing({outer, reversed(inner)}).conflicts(), IsEmpty());
  EXPECT_THAT(drawing({outer, reversed(inner), innermost, beside}).conflicts(), IsEmpty());
  EXPECT_THAT(drawing({reversed(outer), inner, beside}).conflicts(), Not(IsEmpty()));
  EXPECT_THAT(drawing({reversed(outer), inner}).conflicts(-1), IsEmpty());
  EXPECT_THAT(drawing({outer, inner}).conflicts(), Not(IsEmpty())) << "two turns";
  EXPECT_THAT(drawing({outer, beside, reversed(innermost), reversed(inner)}).conflicts(),
              Not(IsEmpty()))
      << "a hole in a hole";
  EXPECT_THAT(drawing({outer, reversed(beside)}).conflicts(), Not(IsEmpty()));
}

TEST(RegionConflicts, name_the_edges_that_cross) {
  Drawing crossing = drawing({square(0, 0, 4), square(10, 0, 4)});
  EXPECT_THAT(crossing.conflicts(), IsEmpty());
  crossing.add({{3, 1}, {11, 1}, {11, 2}, {3, 2}});
  EXPECT_THAT(crossing.conflicts(), testing::ElementsAre(1, 7, 8, 10));
  EXPECT_THAT(drawing({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}).conflicts(), testing::ElementsAre(0, 2));
}

TEST(RegionConflicts, are_found_where_curves_touch_by_other_points) {
  EXPECT_THAT(drawing({square(0, 0, 4), square(4, 4, 4)}).conflicts(), Not(IsEmpty()));
  EXPECT_THAT(drawing({square(0, 0, 4), square(4, 1, 2)}).conflicts(), Not(IsEmpty()));
  EXPECT_THAT(drawing({square(0, 0, 4), square(5, 1, 2)}).conflicts(), IsEmpty());
  EXPECT_THAT(drawing({{{0, 0}, {4, 0}, {2, 0}, {2, 4}}}).conflicts(), Not(IsEmpty())) << "folded";
}

TEST(RegionConflicts, allow_curves_through_one_point) {
  const std::vector<Vec3> points = {{0, 0, 0}, {2, -1, 0}, {2, 1, 0}, {-2, 1, 0}, {-2, -1, 0}};
  const std::vector<DirectedEdge> apart = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}};
  EXPECT_THAT(region_conflicts(points, apart, 2, 1), IsEmpty());
  EXPECT_THAT(region_conflicts(points, apart, 2, -1), Not(IsEmpty()));
  std::vector<DirectedEdge> against = apart;
  for (std::size_t i = 3; i < 6; ++i) {
    std::swap(against[i].from, against[i].to);
  }
  EXPECT_THAT(region_conflicts(points, against, 2, 1), Not(IsEmpty()));
}

/// How often the edges wind about a place on no edge, which lies at no point's height.
int winding(const Drawing& drawing, double x, double y) {
  int count = 0;
  for (const auto& [from, to] : drawing.edges) {
    const Vec3 &a = drawing.points[from], &b = drawing.points[to];
    if ((a.y() < y) != (b.y() < y)) {
      const double side = (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
      count += a.y() < y ? (side > 0 ? 1 : 0) : (side < 0 ? -1 : 0);
    }
  }
  return count;
}

/// Closed random walks over few places, points in common: what has no conflicts winds about
/// everything once at most.
TEST(RegionConflicts, are_there_wherever_edges_wind_twice) {
  std::mt19937 random(20261122);
  constexpr int kSide = 5;
  std::size_t clear = 0, pinched = 0, several = 0;
  for (int round = 0; round < 200000; ++round) {
    Drawing drawing;
    for (int i = 0; i < kSide * kSide; ++i) {
      drawing.points.emplace_back(i % kSide, i / kSide, random() % 5);
    }
    const std::size_t curves = 1 + random() % 2;
    for (std::size_t c = 0; c < curves; ++c) {
      const std::size_t count = 3 + random() % 5;
      std::vector<std::uint32_t> way;
      while (way.size() < count) {
        const auto next = static_cast<std::uint32_t>(random() % (kSide * kSide));
        if (way.empty() || (next != way.back() && next != way.front())) {
          way.push_back(next);
        }
      }
      for (std::size_t i = 0; i < count; ++i) {
        drawing.edges.push_back({way[i], way[(i + 1) % count]});
      }
    }
    for (const int turn : {1, -1}) {
      if (!drawing.conflicts(turn).empty()) {
        continue;
      }
      std::set<int> windings;
      for (int x = 0; x < 8 * kSide; ++x) {
        for (int y = 0; y < 8 * kSide; ++y) {
          windings.insert(winding(drawing, x / 8.0 + 0.0123, y / 8.0 + 0.0071));
        }
      }
      std::set<std::uint32_t> origins;
      for (const DirectedEdge& edge : drawing.edges) {
        origins.insert(edge.from);
      }
      ++clear;
      pinched += origins.size() < drawing.edges.size() ? 1 : 0;
      several += curves > 1 && origins.size() == drawing.edges.size() ? 1 : 0;
      ASSERT_EQ(windings, (std::set<int>{0, turn})) << round;
    }
  }
  EXPECT_GT(clear, 5000);
  EXPECT_GT(pinched, 100);
  EXPECT_GT(several, 100);
}

}  // namespace
}  // namespace dupin::checking
