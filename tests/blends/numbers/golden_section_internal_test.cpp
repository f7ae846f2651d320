#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "numbers/golden_section.h"

namespace dupin::numbers {
namespace {

TEST(GoldenSection, finds_valleys_smooth_or_not) {
  for (const double valley : {-0.9, 0.1, 1.7}) {
    const auto edge = golden_section([=](double x) { return std::abs(x - valley); }, -1, 2, 70);
    EXPECT_NEAR(edge.at, valley, 1e-14);
    EXPECT_EQ(edge.value, std::abs(edge.at - valley));
    // Of a parabola doubles show the square root of their precision.
    const auto smooth =
        golden_section([=](double x) { return 5 + (x - valley) * (x - valley); }, -1, 2, 70);
    EXPECT_NEAR(smooth.at, valley, 1e-7);
  }
}

TEST(GoldenSection, shrinks_by_the_golden_ratio) {
  for (const int sections : {0, 5, 20}) {
    int calls = 0;
    const auto found = golden_section(
        [&](double x) {
          ++calls;
          return std::abs(x - 1. / 3);
        },
        0, 1, sections);
    EXPECT_EQ(calls, sections + 2);
    EXPECT_LE(found.value, std::pow(0.6180339887498949, sections));
  }
}

TEST(GoldenSection, goes_to_the_end_of_a_function_that_falls) {
  EXPECT_GT(golden_section([](double x) { return -x; }, 0, 1, 60).at, 1 - 1e-12);
  EXPECT_LT(golden_section([](double x) { return x; }, 0, 1, 60).at, 1e-12);
}

TEST(GoldenSection, needs_values_only_to_be_ordered) {
  // First what is missing, then what is to be small: least where nothing is missing any more.
  const auto found =
      golden_section([](double x) { return std::pair(std::max(0., 0.25 - x), x * x); }, 0, 1, 60);
  EXPECT_NEAR(found.at, 0.25, 1e-12);
}

}  // namespace
}  // namespace dupin::numbers
