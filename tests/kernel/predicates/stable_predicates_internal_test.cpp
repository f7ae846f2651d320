#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "checking/injective_stars.h"
#include "checking/projected_contours.h"
#include "kernel/moved_points.h"
#include "predicates/stable_predicates.h"
#include "predicates/triangle_overlap.h"

namespace dupin::predicates {
namespace {

std::vector<Vec3> random_points(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Vec3> points;
  while (points.size() < count) {
    points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  }
  return points;
}

/// From 1e-9 to 0.1.
double random_margin(std::mt19937& random) {
  return std::pow(10, std::uniform_real_distribution<double>(-9, -1)(random));
}

TEST(StableSigns, of_lines_stay_wherever_points_move) {
  std::mt19937 random(20261122);
  std::size_t stable = 0, changed = 0;
  for (int round = 0; round < 40000; ++round) {
    std::vector<Vec3> p = random_points(random, 3);
    const double margin = random_margin(random);
    p[2] = p[0] + (p[1] - p[0]) * p[2].x() + 4 * margin * p[2];  // near the line
    const int axis = round % 3, side = stable_side_of_line(p[0], p[1], p[2], axis, margin);
    stable += side != 0 ? 1 : 0;
    for (int i = 0; i < 8; ++i) {
      const std::vector<Vec3> q = test::moved_points(p, margin, random);
      const int now = exact_side_of_line(q[0], q[1], q[2], axis);
      if (side != 0) {
        ASSERT_EQ(now, side) << round;
      }
      changed += now != exact_side_of_line(p[0], p[1], p[2], axis) ? 1 : 0;
    }
  }
  EXPECT_GT(stable, 2000);
  EXPECT_GT(changed, 20000);
}

TEST(StableSigns, are_0_at_the_margin_that_makes_them_change) {
  const Vec3 a(0, 0, 0), b(8, 0, 0), p(4, 1, 0);
  // At 1/2 the ends rise and p sinks to one line.
  EXPECT_EQ(stable_side_of_line(a, b, p, 2, 0.5), 0);
  EXPECT_EQ(stable_side_of_line(a, b, p, 2, 0.25), 1);
  EXPECT_EQ(stable_side_of_line(b, a, p, 2, 0.25), -1);
  EXPECT_TRUE(keeps_area(a, b, p, 0.25));
  EXPECT_FALSE(keeps_area(a, b, p, 0.5));
  EXPECT_FALSE(keeps_area(a, b, Vec3(4, 0, 0), 0));
  EXPECT_EQ(stable_side_of_line(a, b, p, 2, INFINITY), 0);
  EXPECT_EQ(stable_side_of_line(a, b, Vec3(4, 1e300, 0) * 1e10, 2, 0), 0);
}

/// Two triangles near each other that have so many corners in common.
std::pair<Triangle, Triangle> neighbours(std::uint32_t common) {
  return {{0, 1, 2}, {common > 0 ? 0U : 3, common > 1 ? 1U : 4, 5}};
}

TEST(StableSigns, of_triangles_apart_stay_wherever_points_move) {
  std::mt19937 random(20261123);
  for (const std::uint32_t common : {0U, 1U, 2U}) {
    const auto [s, t] = neighbours(common);
    std::size_t apart = 0, known = 0, met = 0;
    for (int round = 0; round < 30000; ++round) {
      std::vector<Vec3> p = random_points(random, 6);
      const double margin = random_margin(random);
      const bool flat = round % 2 == 0;  // in a plane, but for a little
      if (flat) {
        for (Vec3& point : p) {
          point.z() = point.x() - 2 * point.y() + 3 * margin * point.z();
        }
      }
      const bool keep = keep_apart(p, s, t, margin);
      ASSERT_EQ(keep_apart(p, t, s, margin), keep);
      const bool are = TriangleOverlapTest(p, s).meeting(t) == TriangleOverlap::none;
      apart += are && !flat && margin < 1e-6 ? 1 : 0;
      known += keep && !flat && margin < 1e-6 ? 1 : 0;
      for (int i = 0; i < 8; ++i) {
        const bool meet =
            TriangleOverlapTest(test::moved_points(p, margin, random), s).meeting(t) !=
            TriangleOverlap::none;
        ASSERT_FALSE(keep && meet) << round;
        met += are && meet ? 1 : 0;
      }
    }
    EXPECT_GT(known, apart * 99 / 100) << common;
    EXPECT_GT(apart, 1000) << common;
    EXPECT_TRUE(met > 100 || common == 2) << common;
  }
}

TEST(StableSigns, do_not_hold_for_triangles_that_coincide) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  EXPECT_FALSE(keep_apart(points, {0, 1, 2}, {0, 1, 2}, 0));
  EXPECT_FALSE(keep_apart(points, {0, 1, 2}, {2, 1, 0}, 0));
  EXPECT_FALSE(keep_apart(points, {0, 1, 2}, {0, 1, 3}, 0.1));
  EXPECT_TRUE(keep_apart(points, {0, 1, 2}, {1, 3, 2}, 0.1));
}

TEST(StableSigns, do_not_hold_where_numbers_overflow) {
  const Triangle s = {0, 1, 2}, t = {3, 4, 5};
  for (const double size : {1.0, 1e-200, 1e100, 1e160, 1e300}) {
    std::vector<Vec3> points = {{0, 0, 0},      {1, 0, 0.1},     {0, 1, 0.2},
                                {0.2, 0.2, -1}, {0.3, 0.2, 1.5}, {0.2, 0.4, 1.1}};
    for (Vec3& point : points) {
      point *= size;
    }
    EXPECT_FALSE(keep_apart(points, s, t, 0)) << size;
    EXPECT_FALSE(keep_apart(points, t, s, 0)) << size;
    for (std::size_t i = 3; i < 6; ++i) {
      points[i].x() += 2 * size;
    }
    EXPECT_EQ(keep_apart(points, s, t, 1e-3 * size), size == 1 || size == 1e100) << size;
  }
}

TEST(StableSigns, of_stars_stay_wherever_points_move) {
  std::mt19937 random(20261124);
  std::size_t flat = 0, lost = 0;
  for (int round = 0; round < 3000; ++round) {
    const std::uint32_t spokes = 3 + static_cast<std::uint32_t>(round % 6);
    std::vector<Vec3> points = {Vec3::Zero()};
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < spokes; ++i) {
      const double angle = 6.28318 * i / spokes;
      points.push_back(Vec3(std::cos(angle), std::sin(angle), 0) +
                       0.4 * random_points(random, 1)[0]);
      triangles.push_back({0, 1 + i, 1 + (i + 1) % spokes});
    }
    const double margin = random_margin(random);
    const auto is_flat = [&](double by) {
      return checking::injective_stars(points, triangles,
                                       std::vector<std::uint8_t>(points.size(), 0), by)[0] != 0;
    };
    const bool keeps = is_flat(margin);
    flat += keeps ? 1 : 0;
    lost += !keeps && is_flat(0) ? 1 : 0;
    for (int i = 0; keeps && i < 8; ++i) {
      const std::vector<Vec3> moved = test::moved_points(points, margin, random);
      for (const Triangle& s : triangles) {
        const TriangleOverlapTest probe(moved, s);
        ASSERT_TRUE(std::ranges::all_of(triangles, [&](const Triangle& t) {
          return s == t || probe.meeting(t) == TriangleOverlap::none;
        })) << round;
      }
    }
  }
  EXPECT_GT(flat, 500);
  EXPECT_GT(lost, 30);
}

TEST(StableSigns, of_regions_stay_wherever_points_move) {
  std::mt19937 random(20261125);
  std::size_t stable = 0, lost = 0;
  for (int round = 0; round < 4000; ++round) {
    // Polygons around two centres, or one in the other.
    std::vector<Vec3> points;
    std::vector<checking::DirectedEdge> edges;
    const bool nested = round % 2 == 0;
    for (const bool second : {false, true}) {
      const auto first = static_cast<std::uint32_t>(points.size());
      const auto count = 3 + static_cast<std::uint32_t>(random() % 12);
      for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = (nested && second ? -6.28318 : 6.28318) * i / count;
        const double radius = nested && second ? 0.3 : 1;
        points.push_back(radius * Vec3(std::cos(angle), std::sin(angle), 0) +
                         0.2 * random_points(random, 1)[0] +
                         Vec3(!nested && second ? 2.2 : 0, 0, 0));
        edges.push_back({first + i, first + (i + 1) % count});
      }
    }
    const double margin = random_margin(random);
    const bool keeps = checking::region_conflicts(points, edges, 2, 1, margin).empty();
    stable += keeps ? 1 : 0;
    lost += !keeps && checking::region_conflicts(points, edges, 2, 1).empty() ? 1 : 0;
    for (int i = 0; keeps && i < 8; ++i) {
      ASSERT_TRUE(
          checking::region_conflicts(test::moved_points(points, margin, random), edges, 2, 1)
              .empty())
          << round;
    }
  }
  EXPECT_GT(stable, 500);
  EXPECT_GT(lost, 50);
}

TEST(StableSigns, of_collinear_edges_stay_where_they_go_on) {
  // A square with points along its sides, which are on the sides' lines.
  std::vector<Vec3> points;
  std::vector<checking::DirectedEdge> edges;
  const std::array<Vec3, 4> corners = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(4, 4, 0), Vec3(0, 4, 0)};
  for (std::size_t k = 0; k < 4; ++k) {
    for (int i = 0; i < 4; ++i) {
      points.emplace_back(corners[k] + (corners[(k + 1) % 4] - corners[k]) * i / 4);
    }
  }
  for (std::uint32_t i = 0; i < 16; ++i) {
    edges.push_back({i, (i + 1) % 16});
  }
  EXPECT_TRUE(checking::region_conflicts(points, edges, 2, 1, 0.1).empty());
  EXPECT_FALSE(checking::region_conflicts(points, edges, 2, 1, 0.5).empty());
}

}  // namespace
}  // namespace dupin::predicates
