#include <gtest/gtest.h>

#include "mesh/used_points.h"

namespace dupin::mesh {
namespace {

TEST(UsedPoints, are_numbered_in_their_order) {
  const std::vector<Triangle> triangles = {{7, 2, 5}, {5, 2, 0}};
  const UsedPoints used = used_points(triangles, 9);
  EXPECT_EQ(used.points, (std::vector<std::uint32_t>{0, 2, 5, 7}));
  EXPECT_EQ(used.number[5], 2);
  for (const std::uint32_t unused : {1, 3, 4, 6, 8}) {
    EXPECT_EQ(used.number[unused], support::kNone);
  }
  EXPECT_EQ(used.renumbered(triangles[0]), (Triangle{3, 1, 2}));
  EXPECT_TRUE(used_points({}, 3).points.empty());
}

}  // namespace
}  // namespace dupin::mesh
