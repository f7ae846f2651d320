#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tessellation/shortest_way.h"

namespace dupin::tessellation {
namespace {

struct Box {
  double left, right, low, high;
};

double gap(double low, double high, double other_low, double other_high) {
  return std::max({0.0, other_low - high, low - other_high});
}

double distance(const Box& a, const Box& b) {
  return std::hypot(gap(a.left, a.right, b.left, b.right), gap(a.low, a.high, b.low, b.high));
}

std::vector<HeightRange> heights(const std::vector<Box>& boxes) {
  std::vector<HeightRange> result;
  for (const Box& box : boxes) {
    result.push_back({box.low, box.high});
  }
  return result;
}

// By R. W. Floyd (1962).
double shortest_length(std::size_t count, const StepLength& step) {
  std::vector<std::vector<double>> length(count, std::vector<double>(count));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < count; ++k) {
      length[i][k] = step(i, k).value_or(std::numeric_limits<double>::infinity());
    }
  }
  for (std::size_t via = 0; via < count; ++via) {
    for (auto& from : length) {
      for (std::size_t k = 0; k < count; ++k) {
        from[k] = std::min(from[k], from[via] + length[via][k]);
      }
    }
  }
  return length[0][1];
}

TEST(ShortestWay, is_as_short_as_the_shortest_of_all) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(0, 10), size(0, 2), chance(0, 1);
  std::size_t found = 0, found_none = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<Box> boxes{{0, 10, -1, 0}, {0, 10, 10, 11}};
    for (std::size_t i = 0; i < 2 + std::size_t(round) % 20; ++i) {
      const double x = place(random), y = place(random);
      boxes.push_back({x, x + size(random), y, y + size(random)});
    }
    // Short steps are open more often than long ones.
    std::vector<std::vector<double>> luck(boxes.size(), std::vector<double>(boxes.size()));
    for (auto& of_one : luck) {
      for (double& of_step : of_one) {
        of_step = chance(random);
      }
    }
    const StepLength step = [&](std::size_t i, std::size_t k) {
      const double length = distance(boxes[i], boxes[k]);
      return luck[i][k] < std::exp(-length / 3) ? std::optional(length) : std::nullopt;
    };
    const auto way = shortest_way(heights(boxes), step);
    const double shortest = shortest_length(boxes.size(), step);
    ASSERT_EQ(way.empty(), std::isinf(shortest));
    if (way.empty()) {
      ++found_none;
      continue;
    }
    ++found;
    ASSERT_EQ(way.back(), 1U);
    double length = 0;
    std::size_t at = 0;
    for (const std::size_t next : way) {
      ASSERT_TRUE(step(at, next).has_value());
      length += *step(at, next);
      at = next;
    }
    ASSERT_NEAR(length, shortest, 1e-12);
  }
  EXPECT_GT(found, 50U);
  EXPECT_GT(found_none, 50U);
}

TEST(ShortestWay, along_a_row_asks_for_steps_between_neighbours) {
  constexpr std::size_t kCount = 400;
  std::vector<HeightRange> places{{0, 0}, {10 * (kCount + 1), 10 * (kCount + 1)}};
  for (std::size_t i = 1; i <= kCount; ++i) {
    places.push_back({10.0 * double(i) - 2, 10.0 * double(i) + 2});
  }
  std::size_t asked = 0;
  const auto way = shortest_way(places, [&](std::size_t i, std::size_t k) {
    ++asked;
    const double rise = gap(places[i].low, places[i].high, places[k].low, places[k].high);
    return std::optional(std::hypot(rise, 2.0));
  });
  EXPECT_EQ(way.size(), kCount + 1);
  EXPECT_LE(asked, 3 * kCount);
}

}  // namespace
}  // namespace dupin::tessellation
