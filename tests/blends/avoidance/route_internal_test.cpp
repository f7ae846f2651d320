#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "avoidance/route.h"
#include "dupin/blends/frame.h"
#include "dupin/blends/regularity.h"
#include "dupin/kernel/error.h"
#include "support/shapes.h"

namespace dupin::avoidance {
namespace {

const Ring kFrom{{0, 0, 0}, Vec3::UnitX(), 0.5}, kTo{{10, 0, 0}, -Vec3::UnitX(), 0.4};

Obstacle box(const Vec3& low, const Vec3& high) { return box_about({low, high}); }

// By points all over the pipe, which know nothing of discs and planes.
double sampled_clearance(const Route& found, const std::vector<NamedObstacle>& obstacles) {
  double least = 1e300;
  for (const RingedSurface& piece : found.pipe) {
    const FrameField field(piece.spine, reference_axis(piece.start));
    for (int i = 0; i <= 60; ++i) {
      for (int k = 0; k < 24; ++k) {
        const Vec3 point = evaluate(piece, field, i / 60., 2 * std::numbers::pi * k / 24).position;
        for (const NamedObstacle& obstacle : obstacles) {
          least = std::min(least, (point - nearest_core_point(obstacle.shape, point)).norm() -
                                      obstacle.shape.radius);
        }
      }
    }
  }
  return least;
}

void expect_sound(const Route& found, const std::vector<NamedObstacle>& obstacles,
                  double clearance) {
  EXPECT_GE(found.clearance, clearance);
  EXPECT_GE(sampled_clearance(found, obstacles), found.clearance - 1e-9);
  EXPECT_EQ(found.pipe.size(), found.through.size() + 1);
  for (const RingedSurface& piece : found.pipe) {
    EXPECT_GT(regularity(piece).lower, 0);
  }
  EXPECT_EQ(found.pipe.front().start, flipped(kFrom));
  EXPECT_EQ(found.pipe.back().end, flipped(kTo));
}

TEST(Route, goes_straight_where_nothing_is_in_the_way) {
  const std::vector<NamedObstacle> aside{{"", {{5, 9, 0}, {}, 1}}};
  EXPECT_TRUE(route(kFrom, {}, kTo, aside, 0.1).through.empty());
}

// [mathematics A8]: a ball, a box, a ball and a capsule; and two half walls, which take a way in S.
TEST(Route, goes_round_what_is_in_the_way) {
  const std::vector<std::vector<NamedObstacle>> scenes{
      {{"ball", {{5, 0.2, 0}, {}, 1.5}}},
      {{"box", box({4, -1, -1}, {6, 1, 1.5})}},
      {{"ball", {{3, 0.5, 0}, {}, 1}}, {"capsule", {{7, -4, -1}, {{0, 8, 0}}, 0.7}}},
      {{"left", box({3, -20, -20}, {3.5, 1, 20})}, {"right", box({6.5, -1, -20}, {7, 20, 20})}}};
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Route found = route(kFrom, {}, kTo, scenes[i], 0.1);
    EXPECT_FALSE(found.through.empty()) << i;
    expect_sound(found, scenes[i], 0.1);
  }
}

TEST(Route, goes_round_meshes) {
  const std::vector<NamedObstacle> mesh{
      obstacle_of("box.off", test::box({4, -1, -1}, {6, 1, 1.5}))};
  const Route found = route(kFrom, {}, kTo, mesh, 0.1);
  EXPECT_FALSE(found.through.empty());
  expect_sound(found, {{"box", box({4, -1, -1}, {6, 1, 1.5})}}, 0.1);
}

TEST(Route, goes_through_what_it_is_told_to) {
  const std::vector<NamedObstacle> ball{{"ball", {{5, 0, 0}, {}, 1.5}}};
  const Waypoint given{{5, 0, 4}, 0.3};
  const Route found = route(kFrom, {given}, kTo, ball, 0.2);
  expect_sound(found, ball, 0.2);
  EXPECT_TRUE(std::ranges::any_of(found.through, [&](const Waypoint& one) {
    return one.point == given.point && one.radius == given.radius;
  }));
}

bool folds(const Ring& from, const Ring& to) {
  try {
    (void)spline_pipe(from, {}, to);
    return false;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::irregular_surface);
    return true;
  }
}

// There and back, side by side: the spline without points turns too sharply.
TEST(Route, is_straight_pipes_and_elbows_where_the_spline_folds) {
  const std::vector<NamedObstacle> ball{{"ball", {{9, 1, 0}, {}, 1}}};
  int folded = 0;
  for (const double apart : {1.8, 2.2, 2.6, 3.0}) {
    const Ring back{{0, apart, 0}, Vec3::UnitX(), 0.5};
    folded += folds(kFrom, back) ? 1 : 0;
    const Route found = route(kFrom, {}, back, ball, 0.1);
    EXPECT_GE(sampled_clearance(found, ball), found.clearance - 1e-9);
    for (const RingedSurface& piece : found.pipe) {
      EXPECT_GT(regularity(piece).lower, 0);
    }
    EXPECT_EQ(found.pipe.front().start, flipped(kFrom));
    EXPECT_EQ(found.pipe.back().end, flipped(back));
  }
  EXPECT_GT(folded, 0);
}

TEST(Route, is_found_or_refused_in_random_scenes) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> along(1.5, 8.5), aside(-2, 2), size(0.2, 1);
  int found = 0;
  for (int scene = 0; scene < 40; ++scene) {
    std::vector<NamedObstacle> obstacles;
    for (int i = 0; i < 3; ++i) {
      const Vec3 at(along(random), aside(random), aside(random));
      const double radius = size(random);
      obstacles.push_back({std::to_string(i), i == 0   ? Obstacle{at, {}, radius}
                                              : i == 1 ? Obstacle{at, {Vec3(0, 3, 1)}, radius}
                                                       : box(at, at + Vec3(radius, 2, 1))});
    }
    try {
      const Route way = route(kFrom, {}, kTo, obstacles, 0.15);
      expect_sound(way, obstacles, 0.15);
      ++found;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::infeasible_blend);
    }
  }
  EXPECT_GT(found, 25);
}

TEST(Route, is_refused_with_its_tightest_spot) {
  const std::vector<NamedObstacle> wall{{"wall", box({4, -900, -900}, {5, 900, 900})}};
  try {
    (void)route(kFrom, {}, kTo, wall, 0.1);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
    EXPECT_THAT(error.what(), testing::HasSubstr("keeps 0.1 from 'wall'"));
    EXPECT_THAT(error.what(), testing::HasSubstr("runs into it at ("));
  }
}

std::string refusal(const std::vector<Waypoint>& through, const Obstacle& obstacle,
                    double clearance) {
  try {
    (void)route(kFrom, through, kTo, std::vector<NamedObstacle>{{"it", obstacle}}, clearance);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// Not any spot that is too near: less clearance, as the message asks for, would not do.
TEST(Route, is_refused_with_where_it_runs_into_something_and_not_where_it_comes_near) {
  for (const double y : {0.2, 0.5, 1.}) {
    EXPECT_THAT(refusal({{{5, y, 0}, 0.3}}, {{5, 0, 0}, {}, 2}, 0.3),
                testing::HasSubstr("runs into it at ("));
  }
}

TEST(Route, is_refused_where_its_ends_are_too_near_themselves) {
  EXPECT_THAT(refusal({}, {{10, 0, 0}, {}, 1}, 0.1),
              testing::HasSubstr("the end at (10, 0, 0) itself lies in it"));
  EXPECT_THAT(refusal({}, {{-3, 0, 0}, {}, 2.5}, 0.75),
              testing::HasSubstr("the end at (0, 0, 0) itself is only 0.5 from it"));
  EXPECT_EQ(refusal({}, {{-3, 0, 0}, {}, 2.5}, 0.25), "");
}

// Of many triangles, too.
TEST(Route, is_refused_where_its_ends_are_too_near_to_a_mesh) {
  const auto why = [](const TriMesh& mesh, double clearance) -> std::string {
    try {
      (void)route(kFrom, {}, kTo, std::vector{obstacle_of("m.off", mesh)}, clearance);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  };
  const TriMesh beside = test::box({-1, -1, 0.75}, {1, 1, 2});
  EXPECT_THAT(why(beside, 0.5), testing::HasSubstr("keeps 0.5 from 'm.off': the end at (0, 0, 0) "
                                                   "itself is only 0.25 from it"));
  EXPECT_EQ(why(beside, 0.2), "");
  EXPECT_THAT(why(test::box({9, 0, -1}, {11, 1, 1}), 0.1),
              testing::HasSubstr("the end at (10, 0, 0) itself lies in it"));
}

TEST(Route, is_the_same_every_time) {
  const std::vector<NamedObstacle> box_in_way{{"box", box({4, -1, -1}, {6, 1, 1.5})}};
  const Route once = route(kFrom, {}, kTo, box_in_way, 0.1),
              twice = route(kFrom, {}, kTo, box_in_way, 0.1);
  ASSERT_EQ(once.through.size(), twice.through.size());
  for (std::size_t i = 0; i < once.through.size(); ++i) {
    EXPECT_EQ(once.through[i].point, twice.through[i].point);
  }
}

}  // namespace
}  // namespace dupin::avoidance
