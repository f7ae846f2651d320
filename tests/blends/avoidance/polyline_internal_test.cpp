#include <random>

#include <gtest/gtest.h>

#include "avoidance/clearance.h"
#include "avoidance/polyline.h"
#include "avoidance/route.h"
#include "dupin/blends/regularity.h"

namespace dupin::avoidance {
namespace {

const Ring kFrom{{0, 0, 0}, Vec3::UnitX(), 0.5}, kTo{{20, 0, 0}, -Vec3::UnitX(), 0.4};

Obstacle box(const Vec3& low, const Vec3& high) { return box_about({low, high}); }

// Walls across, each with a gap at another side, and lids on top and below.
std::vector<NamedObstacle> labyrinth() {
  return {
      {"1", box({4, -20, -4}, {4.5, 4, 4})},         {"2", box({9, -4, -4}, {9.5, 20, 4})},
      {"3", box({14, -20, -4}, {14.5, 4, 4})},       {"lid", box({1, -20, 4}, {18, 20, 4.5})},
      {"floor", box({1, -20, -4.5}, {18, 20, -4})},  {"left", box({1, 9, -4.5}, {18, 9.5, 4.5})},
      {"right", box({1, -9.5, -4.5}, {18, -9, 4.5})}};
}

void expect_sound(const std::vector<RingedSurface>& pipe,
                  const std::vector<NamedObstacle>& obstacles, double clearance) {
  EXPECT_EQ(pipe.front().start, flipped(kFrom));
  EXPECT_EQ(pipe.back().end, flipped(kTo));
  for (std::size_t i = 0; i < pipe.size(); ++i) {
    EXPECT_GT(regularity(pipe[i]).lower, 0) << i;
    if (i > 0) {
      EXPECT_EQ(pipe[i].start, flipped(pipe[i - 1].end));
    }
    const SpinePoint start = evaluate(pipe[i].spine, 0), end = evaluate(pipe[i].spine, 1);
    EXPECT_LT((start.position - pipe[i].start.center).norm(), 1e-12) << i;
    EXPECT_LT((end.position - pipe[i].end.center).norm(), 1e-12) << i;
    EXPECT_LT((start.first.normalized() + pipe[i].start.normal).norm(), 1e-12) << i;
    EXPECT_LT((end.first.normalized() - pipe[i].end.normal).norm(), 1e-12) << i;
  }
  EXPECT_FALSE(prove_clearance(pipe, obstacles, clearance).spot);
}

TEST(Polyline, is_straight_where_nothing_is_in_the_way) {
  const auto pipe = polyline_pipe(kFrom, kTo, {}, 1);
  ASSERT_TRUE(pipe);
  EXPECT_EQ(pipe->size(), 1);
  expect_sound(*pipe, {}, 1);
}

TEST(Polyline, finds_its_way_through_a_labyrinth) {
  const auto pipe = polyline_pipe(kFrom, kTo, labyrinth(), 0.2);
  ASSERT_TRUE(pipe);
  EXPECT_GE(pipe->size(), 9);
  expect_sound(*pipe, labyrinth(), 0.2);
}

TEST(Polyline, is_the_last_resort_of_a_route) {
  const Route found = route(kFrom, {}, kTo, labyrinth(), 0.2);
  EXPECT_GE(found.clearance, 0.2);
  expect_sound(found.pipe, labyrinth(), 0.2);
}

TEST(Polyline, is_none_where_there_is_no_way) {
  std::vector<NamedObstacle> cage{{"", box({3, -99, -99}, {4, 99, 99})}};
  EXPECT_FALSE(polyline_pipe(kFrom, kTo, cage, 0.2));
}

TEST(Polyline, is_sound_wherever_it_is_found) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(3, 17), y(-4, 4), size(1, 6);
  int found = 0;
  for (int scene = 0; scene < 20; ++scene) {
    std::vector<NamedObstacle> boxes;
    for (int i = 0; i < 6; ++i) {
      const Vec3 low(x(random), y(random) - 3, y(random) - 3);
      const Vec3 high = low + Vec3(size(random) / 4, size(random), size(random));
      boxes.push_back({"", box(low, high)});
    }
    if (const auto pipe = polyline_pipe(kFrom, kTo, boxes, 0.3)) {
      ++found;
      expect_sound(*pipe, boxes, 0.3);
    }
  }
  EXPECT_GE(found, 15);
}

}  // namespace
}  // namespace dupin::avoidance
