#include <cmath>

#include <gtest/gtest.h>

#include "shading/patch.h"

namespace dupin::shading {
namespace {

TEST(Patch, of_a_ball_is_met_from_its_centre) {
  const Patch ball = Sphere{{1, 2, 3}, 2};
  const auto foot = foot_on(ball, {1, 2, 6});
  ASSERT_TRUE(foot);
  EXPECT_EQ(foot->distance, 1);
  EXPECT_EQ(foot->normal, Vec3::UnitZ());
  EXPECT_FALSE(foot_on(ball, {1, 2, 3}));
}

TEST(Patch, that_is_flat_has_one_normal) {
  const auto foot = foot_on(FlatPatch{{0, 0, 1}, Vec3::UnitX()}, {-3, 7, 9});
  ASSERT_TRUE(foot);
  EXPECT_EQ(foot->distance, 3);
  EXPECT_EQ(foot->normal, Vec3::UnitX());
}

// A cone's rim is the strip at right angles to the cone.
TEST(Patch, of_a_rim_is_normal_to_the_surface_that_ends_there) {
  const double slope = 0.5;
  const Patch rim = RimPatch{Ring{{0, 0, 1}, Vec3::UnitZ(), 3, slope}};
  const Vec3 radial(0.6, 0.8, 0), of_cone = (radial - slope * Vec3::UnitZ()).normalized();
  for (const double depth : {0.0, 0.4}) {
    const auto foot = foot_on(rim, Vec3(0, 0, 1) + 3 * radial - depth * of_cone);
    ASSERT_TRUE(foot);
    EXPECT_NEAR(foot->distance, 0, 1e-15);
    EXPECT_NEAR(foot->normal.dot(of_cone), 0, 1e-15);
    EXPECT_NEAR(foot->normal.norm(), 1, 1e-15);
    EXPECT_GT(foot->normal.z(), 0);
  }
  const Vec3 along = (Vec3::UnitZ() + slope * radial).normalized();
  EXPECT_NEAR(foot_on(rim, Vec3(0, 0, 1) + 3 * radial + 0.25 * along)->distance, 0.25, 1e-12);
}

TEST(Patch, of_a_tube_is_in_a_box) {
  const RingedSurface pipe{{{0, 0, 0}, {0, 0, -1}, 2, 0},
                           {{0, 0, 480}, {0, 0, 1}, 2, 0},
                           LineSpine{{0, 0, 0}, {0, 0, 480}},
                           ConstantRadius{2}};
  const Eigen::AlignedBox3d box = box_of(SweptPatch(section_family(Piece(pipe))));
  EXPECT_TRUE(box.contains(Vec3(2, 0, 0)));
  EXPECT_TRUE(box.contains(Vec3(0, -2, 480)));
  EXPECT_FALSE(box.contains(Vec3(30, 0, 100)));
  EXPECT_TRUE(box_of(Sphere{{0, 0, 0}, 1}).contains(Vec3(30, 0, 100)));
}

}  // namespace
}  // namespace dupin::shading
