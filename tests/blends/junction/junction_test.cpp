#include "dupin/blends/junction.h"

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/icosahedron.h"

namespace dupin {
namespace {

using ::testing::HasSubstr;

Ring towards(const Vec3& center, const Vec3& direction, double distance, double radius) {
  const Vec3 unit = direction.normalized();
  return {center + distance * unit, -unit, radius};
}

const std::vector<Ring> kFive{
    towards({1, 2, 3}, {1, 0, 0}, 9, 1), towards({1, 2, 3}, {-1, 0.3, 0}, 12, 0.5),
    towards({1, 2, 3}, {0, 1, 0.2}, 10, 1.5), towards({1, 2, 3}, {0.1, -0.6, 1}, 15, 0.8),
    towards({1, 2, 3}, {0.2, -0.6, -1}, 11, 0.3)};

// The collar is tangent to the pipe and to the hub.
void expect_smooth(const Junction& junction) {
  for (const JunctionArm& arm : junction.arms) {
    const PeArc& first = arm.straight ? *arm.straight : arm.collar;
    const PeVector miss = first.start_tangent() - contact_tangent(arm.end);
    EXPECT_LT(miss.m.norm() + std::abs(miss.r), 1e-14);
    const Ring circle = cap_circle(arm);
    for (const ArcPoint& point : {point_at(arm.collar, 1, 0.3), point_at(arm.collar, 1, 2)}) {
      const Vec3 from_hub = point.position - junction.hub.center;
      EXPECT_NEAR(from_hub.norm(), junction.hub.radius, 1e-11);
      EXPECT_LT((from_hub.normalized() - point.normal).norm(), 1e-12);
      EXPECT_NEAR((point.position - circle.center).norm(), circle.radius, 1e-11);
    }
  }
}

TEST(Junction, of_five_pipes_has_its_hub_where_their_axes_meet) {
  const Junction junction = junction_of(kFive);
  EXPECT_LT((junction.hub.center - Vec3(1, 2, 3)).norm(), 1e-12);
  EXPECT_EQ(junction.arms.size(), 5U);
  EXPECT_EQ(unsoundness(junction), "");
  EXPECT_GT(margins(junction).cap_gap, 0.03);
  EXPECT_GT(margins(junction).power, 0.2);
  expect_smooth(junction);
  // Compact: not much thicker than the thickest pipe needs.
  EXPECT_LT(junction.hub.radius, 3);
}

TEST(Junction, gets_smoother_and_larger_on_demand) {
  double radius = 0, straight = 1e9;
  for (const double smoothness : {0.0, 0.5, 1.0}) {
    const Junction junction = junction_of(kFive, {.smoothness = smoothness});
    expect_smooth(junction);
    EXPECT_GT(junction.hub.radius, radius);
    EXPECT_LT(straight_length(junction.arms[1]), straight);
    radius = junction.hub.radius;
    straight = straight_length(junction.arms[1]);
  }
  EXPECT_EQ(straight, 0);
}

TEST(Junction, keeps_what_is_chosen) {
  const Junction junction = junction_of(kFive, {Vec3(1.1, 2, 3), 3.0, std::vector<double>(5, 0.6)});
  EXPECT_EQ(junction.hub.center, Vec3(1.1, 2, 3));
  EXPECT_EQ(junction.hub.radius, 3);
  for (const JunctionArm& arm : junction.arms) {
    EXPECT_NEAR(cap_angle(arm), 0.6, 1e-6);
  }
}

TEST(Junction, of_two_pipes_that_face_each_other_is_a_bulge) {
  const std::vector<Ring> ends{towards({0, 0, 0}, {1, 0, 0}, 5, 1),
                               towards({0, 0, 0}, {-1, 0, 0}, 5, 1)};
  const Junction junction = junction_of(ends);
  EXPECT_NEAR(cap_angle(junction.arms[0]), 75 * std::numbers::pi / 180, 1e-9);
  expect_smooth(junction);
}

TEST(Junction, of_cones_that_widen_and_narrow) {
  std::vector<Ring> ends = kFive;
  ends[0].slope = 0.1;
  ends[2].slope = -0.08;
  const Junction junction = junction_of(ends);
  EXPECT_EQ(unsoundness(junction), "");
  expect_smooth(junction);
}

TEST(Junction, of_twelve_pipes_takes_the_directions_of_an_icosahedron) {
  std::vector<Ring> ends;
  for (const Vec3& direction : test::icosahedron_corners()) {
    ends.push_back(towards({0, 0, 0}, direction, 8, 0.5));
  }
  const Junction junction = junction_of(ends);
  EXPECT_EQ(junction.arms.size(), 12U);
  expect_smooth(junction);
}

TEST(Junction, tells_how_far_ends_that_are_too_near_have_to_go_back) {
  std::vector<Ring> ends = kFive;
  ends[2].center = Vec3(1, 2, 3) + 1.2 * Vec3(0, 1, 0.2).normalized();
  const JunctionSearch search = search_junction(ends);
  ASSERT_FALSE(search.junction.has_value());
  EXPECT_EQ(search.end, std::optional<std::size_t>(2));
  EXPECT_THAT(search.reason,
              HasSubstr("end 3 is too near to the hub's centre: it would have to be"));
  ASSERT_EQ(search.setbacks.size(), 5U);
  EXPECT_GT(search.setbacks[2], 0.1);
  EXPECT_EQ(search.setbacks[0], 0);
  ends[2].center -= search.setbacks[2] * 1.001 * ends[2].normal;
  EXPECT_TRUE(search_junction(ends).junction.has_value());
  try {
    std::ignore = junction_of(std::vector<Ring>{ends[0], {Vec3(1.5, 2, 3), -Vec3::UnitY(), 1}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
  }
}

TEST(Junction, refuses_ends_that_face_away_or_lie_too_close_together) {
  std::vector<Ring> ends = kFive;
  ends[1].normal = -ends[1].normal;
  JunctionSearch search = search_junction(ends);
  EXPECT_EQ(search.end, std::optional<std::size_t>(1));
  EXPECT_THAT(search.reason, HasSubstr("end 2 does not face the hub's centre"));
  ends[1] = towards({1, 2, 3}, {1, 0.01, 0}, 20, 0.5);
  search = search_junction(ends);
  EXPECT_EQ(search.end, std::optional<std::size_t>(1));
  EXPECT_THAT(search.reason, HasSubstr("lie in directions only 0.5"));
}

TEST(Junction, refuses_options_out_of_range) {
  const auto code = [](const std::vector<Ring>& ends, const JunctionOptions& options) {
    try {
      std::ignore = junction_of(ends, options);
    } catch (const Error& error) {
      return error.code();
    }
    return Errc::internal;
  };
  EXPECT_EQ(code({kFive[0]}, {}), Errc::invalid_argument);
  EXPECT_EQ(code(kFive, {.radius = -1}), Errc::invalid_argument);
  EXPECT_EQ(code(kFive, {.cap_angles = {0.5}}), Errc::invalid_argument);
  EXPECT_EQ(code(kFive, {.cap_angles = std::vector<double>(5, 1.6)}), Errc::invalid_argument);
  EXPECT_EQ(code(kFive, {.smoothness = 1.5}), Errc::invalid_argument);
  // Hubs that are too small, and caps that overlap.
  EXPECT_EQ(code(kFive, {.radius = 0.2}), Errc::infeasible_blend);
  EXPECT_EQ(code(kFive, {.cap_angles = std::vector<double>(5, 1.3)}), Errc::infeasible_blend);
}

TEST(Junction, is_unsound_where_caps_overlap_or_straight_pieces_pass_the_hub) {
  Junction junction = junction_of(kFive);
  junction.arms.push_back(junction.arms[0]);
  EXPECT_EQ(unsoundness(junction), "the caps of end 1 and end 6 overlap");
  const PeVector hub{Vec3(0, 0, 0), 2}, past{Vec3(0.5, 9, 0), 1}, along{Vec3(1, 0, 0), 0};
  const PeArc straight = PeArc::from(past - 5 * along, along, past);
  const JunctionArm passing{contact_ring(straight.start(), along), straight,
                            PeArc::from(past, straight.end_tangent(), hub)};
  const JunctionArm other{{Vec3(0, -5, 0), Vec3(0, 1, 0), 1},
                          {},
                          PeArc::from({Vec3(0, -5, 0), 1}, {Vec3(0, 1, 0), 0}, hub)};
  EXPECT_NE(unsoundness({{Vec3(0, 0, 0), 2}, {passing, other}}), "");
}

TEST(Junction, tubes_run_from_the_ends_to_the_caps) {
  const Junction junction = junction_of(kFive);
  for (const JunctionArm& arm : junction.arms) {
    const Chain chain = tube(arm);
    EXPECT_EQ(chain.pieces.size(), arm.straight ? 2U : 1U);
    EXPECT_EQ(end_ring(chain, End::start), flipped(arm.end));
    EXPECT_EQ(end_ring(chain, End::end), cap_circle(arm));
  }
}

TEST(Junction, says_no_number_that_is_none_of_caps_however_small) {
  for (const double angle : {1e-3, 1e-9, 1e-100, 1e-155, 1e-160, 1e-300, 5e-324}) {
    const JunctionOptions options{.cap_angles = std::vector<double>(kFive.size(), angle)};
    const JunctionSearch found = search_junction(kFive, options);
    EXPECT_EQ(found.reason.find("nan"), std::string::npos) << angle << ": " << found.reason;
    EXPECT_EQ(found.reason.find("inf"), std::string::npos) << angle << ": " << found.reason;
    EXPECT_EQ(found.junction.has_value(), found.reason.empty());
  }
}

}  // namespace
}  // namespace dupin
