#include "dupin/kernel/interior_point.h"

#include <random>

#include <gtest/gtest.h>

#include "dupin/kernel/solid.h"
#include "support/shapes.h"

namespace dupin {
namespace {

std::vector<std::optional<InteriorPoint>> points_in(const std::vector<TriMesh>& meshes) {
  return interior_points(to_mesh(Solid::from(test::joined(meshes))));
}

TEST(InteriorPoints, of_a_box_is_its_middle) {
  const auto points = points_in({test::box({1, 2, 3}, {3, 6, 10})});
  ASSERT_EQ(points.size(), 1);
  ASSERT_TRUE(points[0]);
  EXPECT_GT(points[0]->place.x(), 1);
  EXPECT_LT(points[0]->place.x(), 3);
  EXPECT_GT(points[0]->clearance, 0.5);
  EXPECT_LE(points[0]->clearance, 1);
}

TEST(InteriorPoints, keep_away_from_the_wall_of_a_pipe) {
  const auto points = points_in({test::tube(10, 0, 500, 96)});
  ASSERT_TRUE(points.at(0));
  EXPECT_GT(points[0]->clearance, 9);  // of less than 10 on the axis
  EXPECT_LT(points[0]->place.head<2>().norm(), 1);
}

TEST(InteriorPoints, lie_in_each_component_and_in_no_void) {
  const auto void_in = test::reversed(test::box({1, 1, 1}, {9, 9, 9}));
  const auto points =
      points_in({test::box({0, 0, 0}, {10, 10, 10}), void_in, test::box({4, 4, 4}, {6, 6, 6}),
                 test::box({20, 0, 0}, {21, 1, 1})});
  ASSERT_EQ(points.size(), 3);
  for (const auto& point : points) {
    ASSERT_TRUE(point);
  }
  const Eigen::AlignedBox3d hollow(Vec3(0, 0, 0), Vec3(10, 10, 10)),
      hole(Vec3(1, 1, 1), Vec3(9, 9, 9)), core(Vec3(4, 4, 4), Vec3(6, 6, 6)),
      other(Vec3(20, 0, 0), Vec3(21, 1, 1));
  EXPECT_TRUE(hollow.contains(points[0]->place) && !hole.contains(points[0]->place));
  EXPECT_TRUE(core.contains(points[1]->place));
  EXPECT_TRUE(other.contains(points[2]->place));
}

// Where neighbouring doubles are 2^-22 apart, a plate two of them thick has one layer inside.
TEST(InteriorPoints, are_found_or_missed_by_the_very_numbers) {
  const double far = 0x1p30, step = 0x1p-22;
  const auto two = points_in({test::box({far, 0, 0}, {far + 2 * step, 1, 1})});
  ASSERT_TRUE(two.at(0));
  EXPECT_EQ(two[0]->place.x(), far + step);
  const auto one = points_in({test::box({far, 0, 0}, {far + step, 1, 1})});
  ASSERT_EQ(one.size(), 1);
  EXPECT_FALSE(one[0]);
}

TEST(InteriorPoints, of_random_boxes_are_inside) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(-1000, 1000), size(1e-3, 50);
  for (int i = 0; i < 50; ++i) {
    const Vec3 low(at(random), at(random), at(random));
    const Vec3 high = low + Vec3(size(random), size(random), size(random));
    const auto points = points_in({test::box(low, high)});
    ASSERT_TRUE(points.at(0));
    EXPECT_TRUE(((points[0]->place - low).array() > 0).all() &&
                ((high - points[0]->place).array() > 0).all());
  }
}

}  // namespace
}  // namespace dupin
