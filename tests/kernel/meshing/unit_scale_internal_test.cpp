#include <gtest/gtest.h>

#include "meshing/unit_scale.h"
#include "support/shapes.h"

namespace dupin::meshing {
namespace {

TEST(UnitScale, is_a_power_of_two_about_the_extent) {
  EXPECT_EQ(unit_for({}), 1);
  EXPECT_EQ(unit_for(test::box(Vec3(1e6, 0, 0), Vec3(1e6 + 3, 1, 1))), 2);
  EXPECT_EQ(unit_for(test::box(Vec3::Zero(), Vec3(1, 0x1p-190, 0x1p-190) * 0x1p-190)), 0x1p-190);
}

TEST(UnitScale, is_exact_and_of_all_lengths) {
  const CurvePoints balls = in_unit(CurvePoints{{{Vec3(4, 8, 12), 2, true}}, {{0}}}, 4);
  EXPECT_EQ(balls.points.front(), (CurvePoint{Vec3(1, 2, 3), 0.5, true}));
  Refinement wanted;
  wanted.edge_length = [](const Vec3& point) { return point.x(); };
  wanted.radius = 4;
  wanted.distance = 8;
  wanted.smallest_angle = 0.5;
  wanted.seeds = {{Vec3(4, 4, 8), 3, true}};
  const Refinement less = in_unit(wanted, 4);
  EXPECT_EQ(less.edge_length(Vec3(5, 0, 0)), 5) << "where 20 is, in the unit";
  EXPECT_EQ(less.radius, 1);
  EXPECT_EQ(less.distance, 2);
  EXPECT_EQ(less.smallest_angle, 0.5);
  EXPECT_EQ(less.seeds.front().point, Vec3(1, 1, 2));
}

}  // namespace
}  // namespace dupin::meshing
