#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "junction/collar.h"

namespace dupin::junction {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

TEST(Slides, of_cylinders_on_the_way_to_the_centre_are_the_closed_form) {
  const double radius = 1.4, cap = 57 * kDegree;
  const double setback = (radius - 1) / std::tan(45 * kDegree - cap / 2);
  for (const double distance : {4.0, 1.0}) {
    const auto found = slides({Vec3(-distance, 0, 0), 1}, {Vec3(1, 0, 0), 0},
                              {Vec3(0, 0, 0), radius}, 1 / std::tan(cap));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_GT(found[0], found[1]);
    // Beyond the nearer one the hub would be behind.
    EXPECT_NEAR(found[1], distance - setback, 1e-13);
  }
}

TEST(Slides, of_cones_end_in_the_cap_that_was_asked_for) {
  for (const double slope : {-0.2, 0.15}) {
    const PeVector from{Vec3(-5, 0.3, 0.1), 1}, hub{Vec3(0, 0, 0), 2};
    const PeVector tangent{std::hypot(1, slope) * Vec3(1, 0, 0), slope};
    const double cap = 50 * kDegree;
    const auto found = slides(from, tangent, hub, 1 / std::tan(cap));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_GT(found[0], found[1]);
    EXPECT_NEAR(cap_angle(from + found[0] * tangent, tangent, hub), cap, 1e-12);
  }
}

TEST(Slides, there_are_none_where_the_hub_is_too_small) {
  const auto found = slides({Vec3(-5, 4, 0), 1}, {Vec3(1, 0, 0), 0}, {Vec3(0, 0, 0), 0.5},
                            1 / std::tan(10 * kDegree));
  EXPECT_EQ(found.size(), 0U);
}

TEST(CapShare, is_half_for_equal_pipes_and_in_proportion_otherwise) {
  const double widest = 75 * kDegree;
  EXPECT_NEAR(cap_share(90 * kDegree, 1, 1, widest), 45 * kDegree, 1e-15);
  const double thick = cap_share(90 * kDegree, 2, 1, widest),
               thin = cap_share(90 * kDegree, 1, 2, widest);
  EXPECT_NEAR(thick + thin, 90 * kDegree, 1e-15);
  EXPECT_NEAR(std::sin(thick), 2 * std::sin(thin), 1e-15);
  EXPECT_EQ(cap_share(176 * kDegree, 1, 1, widest), widest);
  // What the thick one cannot use is the thin one's.
  EXPECT_NEAR(cap_share(140 * kDegree, 1, 9, widest), 65 * kDegree, 1e-14);
  EXPECT_EQ(cap_share(140 * kDegree, 9, 1, widest), widest);
}

}  // namespace
}  // namespace dupin::junction
