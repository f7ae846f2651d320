#include <gtest/gtest.h>

#include "blends/network/piping_network_internal.h"
#include "network/piping_spans.h"

namespace dupin::network {
namespace {

TEST(PipingSpans, are_joined_both_ways) {
  const auto spans = spans_of(line_of({component(PipingShape::straight, {{0, 0, 0}, {9, 0, 0}}),
                                       component(PipingShape::straight, {{20, 0, 0}, {9, 0, 0}})}));
  ASSERT_EQ(spans.spans.size(), 2);
  EXPECT_EQ(*spans.joined(spans.spans[0].ends[1]), (std::array<std::size_t, 2>{1, 1}));
  EXPECT_EQ(*spans.joined(spans.spans[1].ends[1]), (std::array<std::size_t, 2>{0, 1}));
  EXPECT_FALSE(spans.joined(spans.spans[0].ends[0]));
}

TEST(PipingSpans, of_bends_are_legs_to_the_corner) {
  const auto spans =
      spans_of(line_of({component(PipingShape::bend, {{-9, 0, 0}, {0, 9, 0}}, Vec3(0, 0, 0))}));
  ASSERT_EQ(spans.spans.size(), 2);
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    EXPECT_EQ(spans.spans[i].role, SpanRole::bend_leg);
    EXPECT_EQ(spans.spans[i].other_leg, 1 - i);
    EXPECT_EQ(spans.spans[i].ends[1].point, Vec3(0, 0, 0));
    EXPECT_TRUE(spans.spans[i].ends[0].port);
  }
}

TEST(PipingSpans, of_teed_bends_have_a_branch_from_the_leg_or_the_arc) {
  auto along = component(PipingShape::bend, {{-90, 0, 0}, {0, 90, 0}, {60, 0, 0}}, Vec3(0, 0, 0));
  EXPECT_EQ(spans_of(line_of({along})).spans[2].ends[0].point, Vec3(-88.2, 0, 0));
  auto aside = component(PipingShape::bend, {{-90, 0, 0}, {0, 90, 0}, {60, -60, 0}}, Vec3(0, 0, 0));
  const Vec3 on_arc = spans_of(line_of({aside})).spans[2].ends[0].point;
  EXPECT_NEAR((on_arc - Vec3(-90, 90, 0)).norm(), 90, 1e-12);
  EXPECT_NEAR(on_arc.x(), -on_arc.y(), 1e-12);
}

TEST(PipingSpans, of_fittings_are_the_run_and_arms_from_the_centre) {
  const auto spans = spans_of(line_of(
      {component(PipingShape::fitting, {{-9, 0, 0}, {0, 0, 9}, {9, 0, 0}}, Vec3(0, 0, 0))}));
  ASSERT_EQ(spans.spans.size(), 2);
  EXPECT_EQ(spans.spans[0].name, "c0");
  EXPECT_EQ(spans.spans[0].ends[1].point, Vec3(9, 0, 0));
  EXPECT_EQ(spans.spans[1].name, "c0-branch");
  EXPECT_EQ(spans.spans[1].ends[0].point, Vec3(0, 0, 0));
  EXPECT_FALSE(spans.spans[1].ends[0].port);
  EXPECT_TRUE(spans.balls.empty());
}

TEST(PipingSpans, of_sharp_fittings_begin_at_different_places_in_a_ball) {
  const auto spans = spans_of(
      line_of({component(PipingShape::fitting, {{0, 0, -60}, {60, 0, 0}}, Vec3(0, 0, 0))}));
  ASSERT_EQ(spans.balls.size(), 1);
  EXPECT_EQ(spans.balls[0].radius, 1.05 * 50);
  EXPECT_NE(spans.spans[0].ends[0].point, spans.spans[1].ends[0].point);
}

TEST(PipingSpans, of_sharp_fittings_begin_inside_of_the_ball_however_long_they_are) {
  for (const double leg : {5., 60., 300., 1e6}) {
    const auto spans = spans_of(
        line_of({component(PipingShape::fitting, {{0, 0, -leg}, {leg, 0, 0}}, Vec3(0, 0, 0))}));
    for (const Span& arm : spans.spans) {
      // The mouth's edge, with any wall taken off both.
      EXPECT_LT(arm.ends[0].point.norm() + arm.radii[0], spans.balls[0].radius);
      EXPECT_LT(arm.ends[0].point.norm(), leg);
    }
  }
}

}  // namespace
}  // namespace dupin::network
