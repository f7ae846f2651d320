#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blends/network/piping_line_builder.h"
#include "dupin/blends/build.h"
#include "dupin/blends/piping_line.h"

namespace dupin::test {
namespace {

TEST(PipingJoints, leaves_ends_apart_beyond_the_snap_and_bridges_them_where_asked) {
  Line line;
  line.pipe({0, 0, 0}, {1000, 0, 0}).pipe({1000, .4, .3}, {2000, .4, .3});
  const PipingNetwork apart = line.made();
  ASSERT_EQ(apart.joints.size(), 1);
  EXPECT_EQ(apart.joints[0].state, JointState::apart);
  EXPECT_NEAR(apart.joints[0].distance, .5, 1e-12);
  EXPECT_EQ(apart.open_ends, 2);
  const PipingNetwork bridged = line.made({.bridge = 1});
  ASSERT_EQ(bridged.joints.size(), 1);
  EXPECT_EQ(bridged.joints[0].state, JointState::bridged);
  EXPECT_NEAR(bridged.joints[0].distance, .5, 1e-12);
  EXPECT_EQ(bridged.joints[0].part, "bridge-12-21");
  EXPECT_EQ(kind(part(bridged, "bridge-12-21").shape), "cyclic_blend");
  EXPECT_EQ(bridged.largest_move, 0);
  (void)solid(bridged);
}

// As far apart as `dupin gaps` takes them for ends that belong together, if it is not told.
TEST(PipingJoints, says_that_ends_miss_each_other_by_up_to_a_millimetre) {
  for (const double gap : {.06, .1, .999}) {
    Line line;
    line.pipe({0, 0, 0}, {500, 0, 0}).pipe({500 + gap, 0, 0}, {900, 0, 0});
    line.pipe({900, 0, 0}, {1200, 0, 0});
    const PipingNetwork network = line.made();
    ASSERT_EQ(network.joints.size(), 2);
    EXPECT_EQ(network.joints[0].state, JointState::apart);
    EXPECT_EQ(network.joints[0].lines, (std::array<std::size_t, 2>{12, 21}));
    EXPECT_EQ(network.joints[1].state, JointState::met);
    EXPECT_EQ(network.open_ends, 2);
  }
  Line far;
  far.pipe({0, 0, 0}, {500, 0, 0}).pipe({501.1, 0, 0}, {900, 0, 0});
  EXPECT_TRUE(far.made().joints.empty());
  EXPECT_EQ(far.made().open_ends, 4);
  Line beside;  // ends that look the same way
  beside.pipe({0, 0, 0}, {500, 0, 0}, .2).pipe({0, .5, 0}, {500, .5, 0}, .2);
  EXPECT_TRUE(beside.made().joints.empty());
}

TEST(PipingJoints, bridges_no_ends_that_look_away_from_each_other) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).pipe({600, 0, 0}, {900, 0, 0});
  const PipingNetwork network = line.made({.bridge = 1000});
  ASSERT_EQ(network.joints.size(), 1);
  EXPECT_EQ(network.joints[0].state, JointState::bridged);
  EXPECT_EQ(network.joints[0].distance, 100);
  EXPECT_EQ(network.open_ends, 2);
  (void)solid(network);
}

// A square of pipes and bends, one bend of which may miss, and one joint of which may be a gap.
TEST(PipingJoints, closes_loops_with_a_gap_or_a_kink_anywhere) {
  for (const int gap_at : {-1, 0, 1, 2, 3}) {
    for (const int kink_at : {-1, 0, 2, 3}) {
      Line line;
      const Vec3 corners[] = {{0, 0, 0}, {1000, 0, 0}, {1000, 1000, 0}, {0, 1000, 0}};
      for (int k = 0; k < 4; ++k) {
        const Vec3 &corner = corners[k], &next = corners[(k + 1) % 4], &last = corners[(k + 3) % 4];
        const Vec3 in = (corner - last).normalized(), out = (next - corner).normalized();
        const Vec3 begin = k == kink_at ? corner : Vec3(corner + 200 * out);
        const Vec3 end = (k + 1) % 4 == kink_at ? next : Vec3(next - 200 * out);
        line.pipe(begin + (k == gap_at ? 2. : 0.) * out, end);
        if (k != kink_at) {
          line.bend(corner - 200 * in, corner, corner + 200 * out);
        }
      }
      const PipingNetwork network = line.made({.bridge = 5});
      EXPECT_EQ(network.open_ends, 0);
      for (const PipingJoint& joint : network.joints) {
        const bool is_kink = joint.kink > .1, is_gap = joint.distance > .05;
        EXPECT_EQ(joint.state == JointState::bridged, is_gap) << gap_at << " " << kink_at;
        EXPECT_NE(joint.state, JointState::apart) << gap_at << " " << kink_at;
        EXPECT_TRUE(!is_kink || joint.state != JointState::met) << gap_at << " " << kink_at;
        EXPECT_EQ(joint.part.empty(), joint.state == JointState::met);
      }
      const Built built = build(network.assembly, {.tolerance = 3});
      EXPECT_EQ(built.solid.components(), 1) << gap_at << " " << kink_at;
      EXPECT_EQ(built.solid.euler_number(), 0) << gap_at << " " << kink_at;
      for (const GapPair& gap : built.gaps) {
        EXPECT_EQ(gap.report.verdict, GapVerdict::welded) << gap_at << " " << kink_at;
      }
    }
  }
}

// Pipe, bend, pipe, where both pipes miss the bend by so much along its legs.
TEST(PipingJoints, bridges_gaps_and_overlaps_along_the_legs_of_bends_by_pipes_and_cones) {
  for (const double before : {-2., -.1, 0., .2, 3.}) {
    for (const double after : {-.2, 0., 1.}) {
      for (const double radius : {50., 44.}) {
        for (const bool is_reversed : {false, true}) {
          Line line;
          const Vec3 in(600 - before, 0, 0), out(800, 200 + after, 0), end(800, 700, 0);
          line.pipe(is_reversed ? in : Vec3::Zero(), is_reversed ? Vec3::Zero() : in, radius);
          line.bend({600, 0, 0}, {800, 0, 0}, {800, 200, 0});
          line.pipe(is_reversed ? end : out, is_reversed ? out : end, radius);
          const PipingNetwork network = line.made({.bridge = 5});
          EXPECT_EQ(kind(part(network, "c1").shape), "elbow") << before << " " << after;
          ASSERT_EQ(network.joints.size(), 2);
          std::size_t bridges = 0;
          for (const PipingJoint& joint : network.joints) {
            if (joint.distance > .05) {
              ASSERT_EQ(joint.state, JointState::bridged) << before << " " << after;
              EXPECT_EQ(kind(part(network, joint.part).shape), radius == 50 ? "pipe" : "cone");
              ++bridges;
            } else {
              EXPECT_EQ(joint.state, radius == 50 ? JointState::met : JointState::stepped);
            }
          }
          EXPECT_EQ(bridges, std::size_t(before != 0) + std::size_t(after != 0));
          EXPECT_EQ(network.open_ends, 2);
          EXPECT_LT(network.largest_move, 1e-9);
          EXPECT_EQ(notes(network), "");
          const double volume = solid(network).volume(), area = std::numbers::pi * radius * radius;
          const double middle = std::numbers::pi * 2500 * std::numbers::pi * 100;
          EXPECT_NEAR(volume, area * 1100 + middle, .03 * volume);
        }
      }
    }
  }
}

TEST(PipingJoints, bridges_gaps_between_two_bends_by_a_pipe_where_there_is_room) {
  for (const double gap : {.2, 3., -1.}) {
    Line line;
    line.pipe({0, 0, 0}, {600, 0, 0}).bend({600, 0, 0}, {800, 0, 0}, {800, 200, 0});
    line.bend({800, 200 + gap, 0}, {800, 400 + gap, 0}, {1000, 400 + gap, 0});
    line.pipe({1000, 400 + gap, 0}, {1500, 400 + gap, 0});
    const PipingNetwork network = line.made({.bridge = 5});
    const PipingJoint& joint = network.joints[1];
    ASSERT_EQ(joint.state, JointState::bridged) << gap;
    EXPECT_EQ(kind(part(network, joint.part).shape), gap > 0 ? "pipe" : "cyclic_blend");
    EXPECT_EQ(kind(part(network, "c1").shape), gap > 0 ? "elbow" : "cyclic_blend");
    (void)solid(network);
  }
}

TEST(PipingJoints, bridges_gaps_beside_parts_that_are_shorter_than_these) {
  for (const double gap : {.2, 30.}) {
    Line line;
    line.bend({600, 0, 0}, {800, 0, 0}, {800, 200, 0});
    line.pipe({800, 200 + gap, 0}, {800, 200.4 + gap, 0})
        .pipe({800, 200.4 + 2 * gap, 0}, {800, 500, 0});
    const PipingNetwork network = line.made({.bridge = 50});
    EXPECT_EQ(kind(part(network, "c0").shape), "elbow") << gap;
    for (const PipingJoint& joint : network.joints) {
      ASSERT_EQ(joint.state, JointState::bridged) << gap;
      EXPECT_EQ(kind(part(network, joint.part).shape), "pipe") << gap;
    }
    (void)solid(network);
  }
}

TEST(PipingJoints, bridges_gaps_beside_eccentric_reducers_which_keep_their_flat_side) {
  for (const double before : {-.2, 0., .3}) {
    for (const double after : {-.3, 0., .2}) {
      for (const bool is_reversed : {false, true}) {
        Line line;
        const Vec3 in(-before, 0, 0), out(150 + after, 0, -20), end(900, 0, -20);
        line.pipe(is_reversed ? in : Vec3(-500, 0, 0), is_reversed ? Vec3(-500, 0, 0) : in);
        line.pipe({0, 0, 0}, {150, 0, -20});
        line.last().is_eccentric = true;
        line.last().ports[1].radius = 30;
        line.pipe(is_reversed ? end : out, is_reversed ? out : end, 30);
        const PipingNetwork network = line.made({.bridge = 1});
        EXPECT_EQ(notes(network), "");
        EXPECT_EQ(kind(part(network, "c1").shape), "oblique") << before << " " << after;
        for (const PipingJoint& joint : network.joints) {
          ASSERT_EQ(joint.state, joint.distance > .05 ? JointState::bridged : JointState::met);
          if (joint.state == JointState::bridged) {
            EXPECT_EQ(kind(part(network, joint.part).shape), "pipe");
          }
        }
        EXPECT_EQ(network.open_ends, 2);
        (void)solid(network);
      }
    }
  }
}

// With straight pieces, as the bend's radius is shorter than its legs.
TEST(PipingJoints, bridges_gaps_beside_the_straight_pieces_of_bends) {
  Line line;
  line.pipe({0, 0, 0}, {600, 0, 0}).bend({600.3, 0, 0}, {800, 0, 0}, {800, 200, 0});
  line.last().bend_radius = 150;
  line.pipe({800, 200, 0}, {800, 700, 0});
  const PipingNetwork network = line.made({.bridge = 5});
  EXPECT_EQ(kind(part(network, "c1").shape), "elbow");
  EXPECT_EQ(kind(part(network, network.joints[0].part).shape), "pipe");
  (void)solid(network);
}

}  // namespace
}  // namespace dupin::test
