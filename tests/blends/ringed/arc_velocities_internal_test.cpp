#include <cmath>

#include <gtest/gtest.h>

#include "ringed/arc_velocities.h"

namespace dupin::ringed {
namespace {

TEST(ArcVelocities, are_near_the_least_energy_and_have_the_margin) {
  for (const double angle : {0.01, 0.3, 1.2}) {
    const Ring from{{0, 0, 0}, {1, 0, 0}, 1};
    const Vec3 leaving(std::cos(angle), std::sin(angle), 0);
    const Ring to{Vec3(6, 0, 0) + 6 * leaving, Vec3::Zero() - leaving, 1};
    const auto speeds = arc_velocities(from, to, 0.3);
    ASSERT_TRUE(speeds) << angle;
    const RingedSurface blend = cyclic_blend(from, to, *speeds);
    EXPECT_GE(regularity(blend).lower, 0.3);
    EXPECT_LT(bending_energy(blend.spine), 1.05 * choose_velocities(from, to).bending_energy);
  }
}

TEST(ArcVelocities, follow_cones_and_are_none_where_the_blend_folds) {
  const Ring cone{{0, 0, 0}, {1, 0, 0}, 1, 0.1}, pipe{{8, 1, 0}, {-1, 0, 0}, 2};
  const auto speeds = arc_velocities(cone, pipe, 0.3);
  ASSERT_TRUE(speeds);
  EXPECT_NO_THROW((void)cyclic_blend(cone, pipe, *speeds));
  EXPECT_FALSE(arc_velocities({{0, 0, 0}, {1, 0, 0}, 5}, {{1, 1, 0}, {0, -1, 0}, 5}, 0.3));
}

}  // namespace
}  // namespace dupin::ringed
