#include <map>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "text/point_merger.h"

namespace dupin::text {
namespace {

TEST(PointMerger, numbers_points_in_order_of_first_appearance) {
  PointMerger merger(3);
  EXPECT_EQ(merger.index_of({0, 0, 1}), 0U);
  EXPECT_EQ(merger.index_of({0, 1, 0}), 1U);
  EXPECT_EQ(merger.index_of({0, 0, 1}), 0U);
  EXPECT_EQ(merger.index_of({1, 0, 0}), 2U);
  EXPECT_EQ(std::move(merger).take_points(), (std::vector<Vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
}

TEST(PointMerger, agrees_with_a_map_however_many_points_were_expected) {
  for (const std::size_t expected : {0U, 10U, 100000U}) {
    PointMerger merger(expected);
    std::map<std::tuple<double, double, double>, std::uint32_t> known;
    std::mt19937_64 random(3);
    std::uniform_int_distribution<int> coordinate(-8, 8);
    for (int i = 0; i < 20000; ++i) {
      // Neighbouring doubles and multiples of powers of two, whose bits differ in few places.
      const Vec3 point(coordinate(random) * 0x1p-40, 1 + coordinate(random) * 0x1p-52,
                       coordinate(random) * 1024);
      const auto [place, fresh] = known.try_emplace({point.x(), point.y(), point.z()},
                                                    static_cast<std::uint32_t>(known.size()));
      ASSERT_EQ(merger.index_of(point), place->second) << fresh;
    }
    EXPECT_EQ(std::move(merger).take_points().size(), known.size());
  }
}

}  // namespace
}  // namespace dupin::text
