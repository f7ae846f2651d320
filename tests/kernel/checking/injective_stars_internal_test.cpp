#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "boxes/tree_traversal.h"
#include "checking/injective_stars.h"
#include "checking/self_intersection.h"
#include "predicates/triangle_overlap.h"
#include "support/none.h"

namespace dupin::checking {
namespace {

struct Fan {
  std::vector<Vec3> points;  // the centre, then the rim
  std::vector<Triangle> triangles;
};

/// Triangles about the origin from each rim point to the next one and from the last to the first.
Fan fan(std::vector<Vec3> rim) {
  const auto count = static_cast<std::uint32_t>(rim.size());
  Fan result{std::move(rim), {}};
  result.points.insert(result.points.begin(), Vec3::Zero());
  for (std::uint32_t i = 0; i < count; ++i) {
    result.triangles.push_back({0, 1 + i, 1 + (i + 1) % count});
  }
  return result;
}

std::vector<Vec3> circle(std::uint32_t count, int turns = 1, double rise = 0) {
  std::vector<Vec3> rim;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * turns * i / count;
    rim.emplace_back(std::cos(angle), std::sin(angle), rise * i);
  }
  return rim;
}

std::uint32_t at_centre(const Fan& fan) {
  return injective_stars(fan.points, fan.triangles,
                         std::vector<std::uint8_t>(fan.points.size(), 0))[0];
}

bool keeps_apart(const Fan& fan) {
  return find_self_intersections(fan.points, fan.triangles, {.active = {}}).none();
}

TEST(FlatStars, are_closed_fans_that_go_round_once) {
  for (const std::uint32_t count : {3U, 5U, 17U, 300U}) {
    EXPECT_EQ(at_centre(fan(circle(count, 1, 1e-3))), count);
    EXPECT_EQ(at_centre(fan(circle(count, -1, 1e-3))), count);
  }
  for (const std::uint32_t count : {7U, 9U, 301U}) {
    EXPECT_EQ(at_centre(fan(circle(count, 2, 1e-3))), 0) << "goes round twice";
  }
  Fan open = fan(circle(8));
  open.triangles.pop_back();
  EXPECT_EQ(at_centre(open), 0);
  std::vector<Vec3> folded = circle(8);
  std::swap(folded[2], folded[3]);
  EXPECT_EQ(at_centre(fan(folded)), 0);
  Fan doubled = fan(circle(8));
  doubled.triangles.push_back(doubled.triangles[0]);
  EXPECT_EQ(at_centre(doubled), 0);
  Fan two = fan(circle(8));
  for (std::size_t i = 0; i < 8; ++i) {
    const Triangle t = two.triangles[i];
    two.triangles.push_back({t[0], t[2], t[1]});
  }
  EXPECT_EQ(at_centre(two), 0) << "both sides";
}

TEST(FlatStars, are_seen_along_every_axis) {
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Vec3> rim = circle(12, 1, 1e-3);
    for (Vec3& p : rim) {
      p = Vec3(p[(3 - axis) % 3], p[(4 - axis) % 3], p[(5 - axis) % 3]);
    }
    EXPECT_EQ(at_centre(fan(rim)), 12);
  }
}

/// Every pair of triangles by itself.
TEST(FlatStars, keep_their_triangles_apart) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> number(-4, 4);
  std::size_t flat = 0, crossing = 0;
  for (int round = 0; round < 20000; ++round) {
    std::vector<Vec3> rim;
    for (int i = 0; i < 3 + round % 4; ++i) {
      rim.emplace_back(number(random), number(random), number(random));
    }
    const Fan star = fan(rim);
    bool meets = false;
    for (std::size_t i = 0; i < star.triangles.size(); ++i) {
      const auto& t = star.triangles[i];
      if (predicates::collinear(star.points[t[0]], star.points[t[1]], star.points[t[2]])) {
        meets = true;
        continue;
      }
      const predicates::TriangleOverlapTest probe(star.points, t);
      for (std::size_t j = 0; j < i && !meets; ++j) {
        meets = probe.meeting(star.triangles[j]) != predicates::TriangleOverlap::none;
      }
    }
    crossing += meets ? 1 : 0;
    if (at_centre(star) != 0) {
      ++flat;
      ASSERT_FALSE(meets) << round;
    }
  }
  EXPECT_GT(flat, 500);
  EXPECT_GT(crossing, 5000);
}

TEST(SelfIntersection, of_a_large_fan_is_found) {
  EXPECT_TRUE(keeps_apart(fan(circle(1000))));
  std::vector<Vec3> rim = circle(1000);
  rim[200] = rim[700];
  rim[200].z() = 0.5;
  rim[700].z() = 1;  // passes from below to above what spans from 199 to 200
  EXPECT_FALSE(keeps_apart(fan(rim)));
  Fan pierced = fan(circle(1000));
  pierced.points.insert(pierced.points.end(), {{0.5, 0.1, -1}, {0.5, 0.1, 1}, {0.5, 0.1005, 1}});
  pierced.triangles.push_back({1001, 1002, 1003});
  EXPECT_EQ(find_self_intersections(pierced.points, pierced.triangles).crossings, 1);
}

TEST(BoxTree, leaves_out_pairs_of_one_group) {
  const Fan large = fan(circle(1000));
  const boxes::BoxQuantizer frame(large.points);
  const auto triangle = [&](std::uint32_t i) {
    const auto& [a, b, c] = large.triangles[i];
    return frame.map(large.points[a], large.points[b], large.points[c]);
  };
  support::BulkVector<boxes::Box> boxes;
  for (std::uint32_t i = 0; i < large.triangles.size(); ++i) {
    boxes.push_back(frame.around(triangle(i)));
  }
  const auto pairs = [&](const std::vector<std::uint32_t>& groups) {
    const boxes::BoxTree tree(boxes, triangle, groups);
    std::size_t count = 0;
    boxes::TreeTraversal(tree).visit([&](std::uint32_t, std::uint32_t) { ++count; });
    return count;
  };
  const std::size_t all = pairs({});
  EXPECT_GT(all, 1000 * 1000 / 16);
  EXPECT_EQ(pairs(std::vector<std::uint32_t>(1000, support::kNone)), all);
  EXPECT_EQ(pairs(std::vector<std::uint32_t>(1000, 7)), 0);
  std::vector<std::uint32_t> half(1000, 7);
  std::fill_n(half.begin(), 500, 3);
  EXPECT_LT(pairs(half), all);
  EXPECT_GT(pairs(half), 0);
}

}  // namespace
}  // namespace dupin::checking
