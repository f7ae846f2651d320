#include <gtest/gtest.h>

#include "blends/network/piping_network_internal.h"
#include "network/piping_stretches.h"

namespace dupin::network {
namespace {

struct Planned {
  explicit Planned(std::vector<PipingComponent> components) : line(line_of(std::move(components))) {
    spans = spans_of(line, {}, notes);
    joints.resize(spans.pairs.size());
    result = plan(line, {}, spans, chains_of(spans, .05).front(), joints, notes);
  }
  PipingLine line;
  LineNotes notes{"a.pcf", true};
  PipingSpans spans;
  std::vector<PipingJoint> joints;
  ChainPlan result;
};

PipingComponent pipe(const Vec3& from, const Vec3& to, double radius = 50) {
  return component(PipingShape::straight, {from, to}, {}, radius);
}

PipingComponent bend(const Vec3& from, const Vec3& corner, const Vec3& to) {
  return component(PipingShape::bend, {from, to}, corner);
}

TEST(PipingStretches, lie_end_to_end) {
  const Planned planned({pipe({0, 0, 0}, {500, 0, 0}), pipe({500, 0, 0}, {900, 0, 0})});
  const auto& stretches = planned.result.stretches.at(0);
  ASSERT_EQ(stretches.size(), 2);
  EXPECT_EQ(stretches[0].levels, (std::array<double, 2>{0, 500}));
  EXPECT_EQ(stretches[1].levels, (std::array<double, 2>{500, 900}));
  EXPECT_TRUE(stretches[1].joint_before);
}

TEST(PipingStretches, end_where_bends_begin) {
  const Planned planned({pipe({-900, 0, 0}, {-300, 0, 0}),
                         bend({-300, 0, 0}, {0, 0, 0}, {0, 300, 0}),
                         pipe({0, 300.06, 0}, {0, 900, 0})});
  // Within the snap tolerance and not: the last pipe is not joined.
  EXPECT_EQ(planned.result.arcs[1]->tangent, 300);
  EXPECT_EQ(planned.result.stretches[0][0].levels[1], 600);
  EXPECT_TRUE(planned.result.stretches[1].empty());
}

TEST(PipingStretches, take_a_bend_radius_that_leaves_straight_pieces) {
  auto with_radius = bend({-300, 0, 0}, {0, 0, 0}, {0, 300, 0});
  with_radius.bend_radius = 200;
  const Planned shorter({with_radius});
  EXPECT_NEAR(shorter.result.arcs[1]->tangent, 200, 1e-12);
  EXPECT_EQ(shorter.result.stretches[0][0].name, "c0-leg");
  with_radius.bend_radius = 299.9;  // as rounded as anything
  EXPECT_EQ(Planned({with_radius}).result.arcs[1]->tangent, 300);
}

TEST(PipingStretches, step_in_the_thicker_pipe) {
  const Planned planned({pipe({0, 0, 0}, {500, 0, 0}, 30), pipe({500, 0, 0}, {900, 0, 0}, 50)});
  const auto& stretches = planned.result.stretches[0];
  ASSERT_EQ(stretches.size(), 3);
  EXPECT_EQ(stretches[1].levels, (std::array<double, 2>{500, 520}));
  EXPECT_EQ(stretches[1].radii, (std::array<double, 2>{30, 50}));
  EXPECT_EQ(planned.joints[0].state, JointState::stepped);
  const Planned little({pipe({0, 0, 0}, {500, 0, 0}, 49.9), pipe({500, 0, 0}, {900, 0, 0}, 50)});
  EXPECT_EQ(little.result.stretches[0][1].length(), 12.5);  // no thin ring
}

TEST(PipingStretches, refuse_sharp_bends) {
  const Planned planned({bend({-50, 0, 0}, {0, 0, 0}, {0, 50, 0})});
  EXPECT_TRUE(planned.result.arcs[1]->is_left_out);
}

}  // namespace
}  // namespace dupin::network
