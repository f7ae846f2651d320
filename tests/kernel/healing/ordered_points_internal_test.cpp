#include <gtest/gtest.h>

#include "healing/ordered_points.h"

namespace dupin::healing {
namespace {

TEST(OrderedPoints, have_places_by_their_coordinates_in_turn) {
  const std::vector<Vec3> points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 5}, {0, 0, -5}};
  EXPECT_EQ(places_by_coordinates(points), (std::vector<std::uint32_t>{3, 2, 1, 0}));
}

}  // namespace
}  // namespace dupin::healing
