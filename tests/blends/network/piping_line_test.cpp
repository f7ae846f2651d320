#include "dupin/blends/piping_line.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/build.h"
#include "dupin/blends/resolve.h"
#include "dupin/kernel/error.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

// Components with a name and lines of their own.
class Line {
 public:
  Line& add(PipingShape shape, std::initializer_list<Vec3> ports, double radius = 50) {
    PipingComponent component;
    component.line = 10 * (line_.components.size() + 1);
    component.name = "c" + std::to_string(line_.components.size());
    component.shape = shape;
    for (const Vec3& port : ports) {
      component.ports.push_back({port, radius, component.line + component.ports.size() + 1});
    }
    line_.components.push_back(component);
    return *this;
  }
  Line& pipe(const Vec3& from, const Vec3& to, double radius = 50) {
    return add(PipingShape::straight, {from, to}, radius);
  }
  Line& bend(const Vec3& from, const Vec3& corner, const Vec3& to, double radius = 50) {
    add(PipingShape::bend, {from, to}, radius);
    last().center = corner;
    return *this;
  }
  Line& tee(const Vec3& from, const Vec3& center, const Vec3& to, const Vec3& branch,
            double radius = 50, double branch_radius = 30) {
    add(PipingShape::fitting, {from, to, branch}, radius);
    last().center = center;
    last().ports[2].radius = branch_radius;
    return *this;
  }
  PipingComponent& last() { return line_.components.back(); }
  [[nodiscard]] PipingNetwork made(const PipingOptions& options = {}) const {
    return assembly_of(line_, options);
  }
  [[nodiscard]] const PipingLine& line() const { return line_; }

 private:
  PipingLine line_{"a.pcf", {}};
};

// Of all parts of the region, which fit without gaps; as many components as said.
Solid solid(const PipingNetwork& network, std::size_t components = 1) {
  Built built = build(network.assembly, {.tolerance = .5});
  EXPECT_EQ(built.solid.components(), components);
  EXPECT_EQ(built.solid.euler_number(), std::ptrdiff_t(2 * components));
  for (const GapPair& gap : built.gaps) {
    EXPECT_TRUE(gap.report.verdict == GapVerdict::welded || gap.report.verdict == GapVerdict::open)
        << built.ports[gap.first].name;
  }
  return built.solid;
}

const Part& part(const PipingNetwork& network, const std::string& name) {
  for (const Part& part : network.assembly.parts) {
    if (part.name == name) {
      return part;
    }
  }
  ADD_FAILURE() << "no part " << name;
  return network.assembly.parts.front();
}

std::string notes(const PipingNetwork& network) {
  std::string text;
  for (const SourceNote& note : network.notes) {
    text += std::to_string(note.line) + ": " + note.text + "\n";
  }
  return text;
}

TEST(PipingLine, joins_what_meets_in_any_order_and_direction) {
  Line line;
  line.pipe({500, 300, 0}, {500, 900, 0}).bend({200, 0, 0}, {500, 0, 0}, {500, 300, 0});
  line.pipe({200, 0, 0}, {0, 0, 0});
  const PipingNetwork network = line.made();
  EXPECT_EQ(network.joints.size(), 2);
  for (const PipingJoint& joint : network.joints) {
    EXPECT_EQ(joint.state, JointState::met);
    EXPECT_EQ(joint.distance, 0);
  }
  EXPECT_EQ(network.open_ends, 2);
  EXPECT_EQ(network.components, 3);
  EXPECT_EQ(network.largest_move, 0);
  EXPECT_EQ(kind(part(network, "c1").shape), "elbow");
  // A cylinder of 800 mm and a quarter of a torus of radius 300.
  const double area = 50 * 50 * std::numbers::pi;
  EXPECT_NEAR(solid(network).volume(), area * (800 + 300 * std::numbers::pi / 2), .03 * area * 800);
}

TEST(PipingLine, snaps_ends_that_miss_each_other_to_one_axis) {
  Line line;
  line.pipe({0, 0, 0}, {1000, .03, 0})
      .pipe({1000, -.01, 0}, {1012, 0, .02})
      .pipe({1012.02, 0, 0}, {3000, 0, 0});
  const PipingNetwork network = line.made();
  for (const PipingJoint& joint : network.joints) {
    EXPECT_EQ(joint.state, JointState::met);
    EXPECT_GT(joint.distance, .02);
  }
  EXPECT_GT(network.largest_move, .01);
  EXPECT_LE(network.largest_move, .05);
  EXPECT_EQ(kind(part(network, "c2").shape), "pipe");
  (void)solid(network);
}

TEST(PipingLine, leaves_ends_apart_beyond_the_snap_and_bridges_them_where_asked) {
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

TEST(PipingLine, bridges_gaps_overlaps_and_other_radii_along_one_axis) {
  for (const double at : {1000.5, 999.5}) {
    for (const double radius : {50.0, 40.0}) {
      Line line;
      line.pipe({0, 0, 0}, {1000, 0, 0}).pipe({at, 0, 0}, {2000, 0, 0}, radius);
      const PipingNetwork network = line.made({.bridge = 1});
      ASSERT_EQ(network.joints.size(), 1);
      EXPECT_EQ(network.joints[0].state, JointState::bridged) << at << radius;
      EXPECT_EQ(kind(part(network, "bridge-12-21").shape), radius == 50 ? "pipe" : "cone");
      EXPECT_EQ(network.largest_move, 0) << "both ends stay where they are along the axis";
      (void)solid(network);
    }
  }
}

TEST(PipingLine, makes_a_cone_of_a_step_in_the_thicker_pipe) {
  Line line;
  line.pipe({0, 0, 0}, {1000, 0, 0}).pipe({1000, 0, 0}, {2000, 0, 0}, 30);
  const PipingNetwork network = line.made();
  EXPECT_EQ(network.joints[0].state, JointState::stepped);
  EXPECT_EQ(network.joints[0].step, 20);
  EXPECT_EQ(network.joints[0].part, "step-12-21");
  const auto& cone = std::get<ConeAlong>(part(network, "step-12-21").shape);
  EXPECT_EQ(cone.length, 20);
  EXPECT_EQ(cone.end_radius, 30);
  (void)solid(network);
}

TEST(PipingLine, steps_from_bends_in_the_pipe) {
  Line line;
  line.bend({-300, 0, 0}, {0, 0, 0}, {0, 300, 0}).pipe({0, 300, 0}, {0, 900, 0}, 30);
  line.pipe({-300, 0, 0}, {-900, 0, 0}, 60);
  const PipingNetwork network = line.made();
  for (const PipingJoint& joint : network.joints) {
    EXPECT_EQ(joint.state, JointState::stepped);
  }
  (void)solid(network);
}

TEST(PipingLine, treats_parts_without_length_as_joints) {
  Line line;
  line.pipe({0, 0, 0}, {1000, 0, 0}).add(PipingShape::straight, {{1000, 0, 0}, {1000, 0, 0}});
  line.last().ports[1].radius = 30;
  line.pipe({1000, 0, 0}, {2000, 0, 0}, 30);
  const PipingNetwork network = line.made();
  ASSERT_EQ(network.joints.size(), 1);
  EXPECT_EQ(network.joints[0].state, JointState::stepped);
  EXPECT_THAT(notes(network), HasSubstr("20: c1: has no length"));
  (void)solid(network);
}

TEST(PipingLine, blends_kinks) {
  Line line;
  line.pipe({0, 0, 0}, {1000, 0, 0}).pipe({1000, 0, 0}, {1900, 300, 0});
  const PipingNetwork network = line.made();
  EXPECT_EQ(network.joints[0].state, JointState::blended);
  EXPECT_NEAR(network.joints[0].kink, std::atan2(300, 900), 1e-12);
  EXPECT_EQ(kind(part(network, network.joints[0].part).shape), "cyclic_blend");
  (void)solid(network);
}

TEST(PipingLine, says_where_no_blend_has_room) {
  Line line;
  line.pipe({0, 0, 0}, {20, 0, 0}).pipe({20, 0, 0}, {20, 20, 0});
  const PipingNetwork network = line.made();
  EXPECT_EQ(network.joints[0].state, JointState::apart);
  EXPECT_EQ(build(network.assembly).solid.components(), 1);
}

TEST(PipingLine, gives_bends_with_unequal_legs_straight_pieces) {
  Line line;
  line.pipe({-900, 0, 0}, {-300, 0, 0}).bend({-300, 0, 0}, {0, 0, 0}, {0, 200, 0});
  line.pipe({0, 200, 0}, {0, 900, 0});
  const PipingNetwork shorter = line.made();
  EXPECT_EQ(kind(part(shorter, "c1-leg").shape), "pipe");
  (void)solid(shorter);
  Line by_radius;
  by_radius.bend({-300, 0, 0}, {0, 0, 0}, {0, 300, 0}).last().bend_radius = 150;
  by_radius.pipe({0, 300, 0}, {0, 900, 0});
  const PipingNetwork both = by_radius.made();
  EXPECT_EQ(kind(part(both, "c0-leg").shape), "pipe");
  EXPECT_EQ(kind(part(both, "c0-leg2").shape), "pipe");
  (void)solid(both);
}

TEST(PipingLine, takes_bends_that_do_not_turn_for_pipes) {
  Line line;
  line.bend({0, 0, 0}, {500, 0, 0}, {1000, 0, 0});
  EXPECT_EQ(kind(part(line.made(), "c0").shape), "pipe");
}

TEST(PipingLine, blends_between_the_neighbours_of_a_bend_that_does_not_fit) {
  Line line;
  line.pipe({-900, 0, 60}, {-300, 0, 0}).bend({-300, 0, 0}, {0, 0, 0}, {0, 300, 0});
  line.pipe({0, 300, 0}, {0, 900, 0});
  const PipingNetwork network = line.made();
  EXPECT_EQ(kind(part(network, "c1").shape), "cyclic_blend");
  EXPECT_THAT(notes(network), HasSubstr("20: c1: is not tangent to its neighbours"));
  (void)solid(network);
}

TEST(PipingLine, blends_bends_that_do_not_fit_without_pipes_beside_them) {
  Line line;
  line.bend({-300, 0, 0}, {0, 0, 0}, {0, 300, 0}).bend({0, 300, 0}, {90, 600, 0}, {90, 600, 313.2});
  const PipingNetwork network = line.made();
  EXPECT_EQ(kind(part(network, "c0").shape), "cyclic_blend");
  EXPECT_EQ(kind(part(network, "c0-stub").shape), "pipe");
  (void)solid(network);
}

TEST(PipingLine, begins_the_branch_of_a_bend_that_does_not_turn_at_its_corner) {
  Line line;
  line.bend({0, 0, 0}, {500, 0, 0}, {1000, 0, 0}).last().ports.push_back({{500, 0, 300}, 20, 13});
  const PipingNetwork network = line.made();
  EXPECT_EQ(std::get<PipeBetween>(part(network, "c0-branch").shape).from, Vec3(500, 0, 0));
  (void)solid(network);
}

TEST(PipingLine, blends_cones_that_meet_pipes_at_a_kink_on_both_sides) {
  Line line;
  line.pipe({0, 0, 0}, {1000, 0, 0}).pipe({1000, 0, 0}, {1400, 100, 0});
  line.last().ports[1].radius = 30;
  line.pipe({1400, 100, 0}, {2000, 100, 0}, 30);
  const PipingNetwork network = line.made();
  for (const PipingJoint& joint : network.joints) {
    EXPECT_EQ(joint.state, JointState::blended);
  }
  (void)solid(network);
}

TEST(PipingLine, refuses_bends_sharper_than_their_pipe) {
  Line line;
  line.pipe({-900, 0, 0}, {-40, 0, 0})
      .bend({-40, 0, 0}, {0, 0, 0}, {0, 40, 0})
      .pipe({0, 40, 0}, {0, 900, 0});
  try {
    (void)line.made();
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::invalid_argument);
    EXPECT_EQ(error.where(), "a.pcf:20");
    EXPECT_EQ(error.part(), "c1");
    EXPECT_THAT(error.what(),
                HasSubstr("its bend radius of 40 is not larger than its pipe's radius of 50"));
  }
  const PipingNetwork network = line.made({.keep_going = true});
  ASSERT_EQ(network.notes.size(), 1);
  EXPECT_TRUE(network.notes[0].is_refusal);
  (void)build(network.assembly);
}

TEST(PipingLine, makes_tees_of_a_run_and_a_branch) {
  Line line;
  line.pipe({-900, 0, 0}, {-100, 0, 0}).tee({-100, 0, 0}, {0, 0, 0}, {100, 0, 0}, {0, 0, 100});
  line.pipe({100, 0, 0}, {900, 0, 0}).pipe({0, 0, 100}, {0, 0, 700}, 30);
  const PipingNetwork network = line.made();
  EXPECT_EQ(network.joints.size(), 3);
  EXPECT_EQ(network.open_ends, 3);
  EXPECT_EQ(kind(part(network, "c1").shape), "pipe");
  EXPECT_EQ(kind(part(network, "c1-branch").shape), "pipe");
  (void)solid(network);
}

TEST(PipingLine, makes_tees_whose_centre_lies_off_the_run_or_whose_run_turns) {
  Line off;
  off.pipe({-900, 0, 0}, {-100, 0, 0}).tee({-100, 0, 0}, {0, 0, 3}, {100, 0, 0}, {0, 0, 100});
  off.pipe({100, 0, 0}, {900, 0, 0});
  EXPECT_EQ(kind(part(off.made(), "c1").shape), "pipe");
  (void)solid(off.made());
  Line turned;  // whose pipes lead to the centre
  turned.pipe({-900, 0, -27}, {-100, 0, 0})
      .tee({-100, 0, 0}, {0, 0, 3.375}, {100, 0, 0}, {0, 0, 100});
  turned.pipe({100, 0, 0}, {900, 0, -27});
  EXPECT_EQ(kind(part(turned.made(), "c1").shape), "elbow");
  (void)solid(turned.made());
}

TEST(PipingLine, takes_the_arms_on_one_line_for_the_run_whatever_they_are_called) {
  Line line;
  line.tee({-100, 0, 0}, {0, 0, 0}, {0, 0, 100}, {100, 0, 0}, 50, 50);
  const PipingNetwork network = line.made();
  const auto& run = std::get<PipeBetween>(part(network, "c0").shape);
  EXPECT_EQ(run.from.z(), run.to.z());
  (void)solid(network);
}

TEST(PipingLine, makes_crosses_and_stubs) {
  Line line;
  line.add(PipingShape::fitting, {{-200, 0, 0}, {200, 0, 0}, {0, 150, 0}, {0, -150, 0}});
  line.last().center = Vec3::Zero();
  line.pipe({200, 0, 0}, {900, 0, 0});
  line.add(PipingShape::fitting, {{500, 0, 80}}, 15).last().center = Vec3(500, 0, 0);
  line.pipe({500, 0, 80}, {500, 0, 300}, 15);
  const PipingNetwork network = line.made();
  EXPECT_EQ(kind(part(network, "c0-branch").shape), "pipe");
  EXPECT_EQ(kind(part(network, "c2").shape), "pipe");
  (void)solid(network);
}

TEST(PipingLine, gives_fittings_that_turn_sharply_a_ball) {
  Line line;
  line.add(PipingShape::fitting, {{0, 0, -60}, {60, 0, 0}}).last().center = Vec3::Zero();
  line.pipe({0, 0, -60}, {0, 0, -500}).pipe({60, 0, 0}, {500, 0, 0});
  const PipingNetwork network = line.made();
  EXPECT_EQ(kind(part(network, "c0").shape), "sphere");
  (void)solid(network);
}

// A fitting of arms of that length and those directions, with pipes joined to it.
Line sharp_fitting(double leg, const std::vector<Vec3>& directions,
                   const std::vector<double>& radii) {
  Line line;
  line.add(PipingShape::fitting, {}).last().center = Vec3::Zero();
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const Vec3 end = leg * directions[k];
    line.last().ports.push_back({end, radii[k], 12 + k});
  }
  for (std::size_t k = 0; k < directions.size(); ++k) {
    line.pipe(leg * directions[k], (leg + 300) * directions[k], radii[k]);
  }
  return line;
}

TEST(PipingLine, joins_the_arms_of_fittings_that_turn_sharply_whatever_their_length_and_wall) {
  const double sine = std::sqrt(.75);
  const std::vector<std::vector<Vec3>> fittings{{{0, 0, -1}, {1, 0, 0}},
                                                {{1, 0, 0}, {-.5, sine, 0}, {-.5, -sine, 0}},
                                                {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (const double leg : {20., 60., 135., 300., 2000.}) {
    for (const auto& directions : fittings) {
      for (const double thin : {50., 20.}) {
        std::vector<double> radii(directions.size(), 50);
        radii.back() = thin;
        PipingOptions options;
        options.wall = 4;
        const PipingNetwork network = sharp_fitting(leg, directions, radii).made(options);
        ASSERT_EQ(kind(part(network, "c0").shape), "sphere");
        const Built outer = build(network.assembly, {.tolerance = 2, .region = Region::outer});
        EXPECT_EQ(outer.solid.components(), 1) << leg;
        EXPECT_EQ(outer.solid.euler_number(), 2) << leg;
        const Built fluid = build(network.assembly, {.tolerance = 2, .region = Region::fluid});
        EXPECT_EQ(fluid.solid.components(), 1) << leg;
        EXPECT_EQ(fluid.solid.euler_number(), 2) << leg;
        const Built metal = build(network.assembly, {.tolerance = 2, .region = Region::metal});
        EXPECT_EQ(metal.solid.components(), 1) << leg;
        EXPECT_EQ(metal.solid.euler_number(), 4 - 2 * std::ptrdiff_t(directions.size())) << leg;
      }
    }
  }
}

// As far apart as `dupin gaps` takes them for ends that belong together, if it is not told.
TEST(PipingLine, says_that_ends_miss_each_other_by_up_to_a_millimetre) {
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

TEST(PipingLine, gives_fittings_a_ball_whose_branch_is_thicker_than_their_run) {
  for (const double thin : {20., 45.}) {
    const PipingNetwork network =
        sharp_fitting(150, {{-1, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {thin, 50 - thin / 2, 50})
            .made({.wall = 4});
    EXPECT_EQ(kind(part(network, "c0").shape), "sphere");
    const Built metal = build(network.assembly, {.tolerance = 2});
    EXPECT_EQ(metal.solid.components(), 1);
    EXPECT_EQ(metal.solid.euler_number(), -2);
  }
}

TEST(PipingLine, bridges_no_ends_that_look_away_from_each_other) {
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
TEST(PipingLine, closes_loops_with_a_gap_or_a_kink_anywhere) {
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

TEST(PipingLine, notes_branches_without_length_and_branches_of_nothing) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).tee({500, 0, 0}, {600, 0, 0}, {700, 0, 0}, {600, 0, 0});
  line.add(PipingShape::fitting, {{300, 2000, 120}}, 25).last().center = Vec3(300, 2000, 0);
  line.add(PipingShape::fitting, {{300, 0, 120}}, 25).last().center = Vec3(300, 20, 0);
  const std::string said = notes(line.made());
  EXPECT_THAT(said, HasSubstr("20: c1: its end at line 23 lies in its centre; there is no arm"));
  EXPECT_THAT(said, HasSubstr("30: c2: its centre lies in no other component; its branch begins "
                              "there, joined to nothing"));
  EXPECT_THAT(said, testing::Not(HasSubstr("c3")));
}

TEST(PipingLine, keeps_eccentric_parts_flat) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).add(PipingShape::straight, {{500, 0, 0}, {600, 0, 20}});
  line.last().is_eccentric = true;
  line.last().ports[1].radius = 30;
  line.pipe({600, 0, 20}, {1200, 0, 20}, 30)
      .bend({1200, 0, 20}, {1300, 0, 20}, {1300, 100, 20}, 30);
  const PipingNetwork network = line.made();
  EXPECT_EQ(kind(part(network, "c1").shape), "oblique");
  const auto resolved = resolve(network.assembly);
  EXPECT_EQ(resolved.parts.size(), 4);
  EXPECT_EQ(network.largest_move, 0);
  (void)solid(network);
  Line first;  // where nothing comes before it
  first.add(PipingShape::straight, {{500, 0, 0}, {600, 0, 20}}).last().is_eccentric = true;
  first.last().ports[1].radius = 30;
  first.pipe({600, 0, 20}, {1200, 0, 20}, 30);
  EXPECT_EQ(kind(part(first.made(), "c0").shape), "oblique");
  (void)solid(first.made());
}

TEST(PipingLine, gives_flat_eccentric_reducers_a_length) {
  for (const bool is_turned : {false, true}) {
    Line line;
    line.pipe({0, 0, 0}, {500, 0, 0});
    const Vec3 thick(500, 0, 0), thin(500, 0, 20);
    line.add(PipingShape::straight, {is_turned ? thin : thick, is_turned ? thick : thin});
    line.last().is_eccentric = true;
    line.last().ports[is_turned ? 0 : 1].radius = 30;
    line.pipe(thin, {1200, 0, 20}, 30);
    const PipingNetwork network = line.made();
    EXPECT_EQ(kind(part(network, "c1").shape), "oblique");
    EXPECT_THAT(notes(network), HasSubstr("it takes 20 of c0"));
    for (const PipingJoint& joint : network.joints) {
      EXPECT_EQ(joint.state, JointState::met);
    }
    (void)solid(network);
  }
}

TEST(PipingLine, blends_between_the_two_bores_of_a_bend) {
  Line line;
  line.pipe({-900, 0, 0}, {-300, 0, 0}).bend({-300, 0, 0}, {0, 0, 0}, {0, 300, 0});
  line.last().ports[1].radius = 40;
  line.pipe({0, 300, 0}, {0, 900, 0}, 40);
  const PipingNetwork network = line.made();
  EXPECT_EQ(kind(part(network, "c1").shape), "cyclic_blend");
  EXPECT_THAT(notes(network), HasSubstr("c1: has two bores; a blend between them"));
  (void)solid(network);
}

TEST(PipingLine, keeps_the_speeds_of_blends_so_that_none_is_looked_for_twice) {
  Line line;
  line.pipe({0, 0, 0}, {1000, 0, 0}).pipe({1000, 0, 0}, {1900, 300, 0});
  const PipingNetwork network = line.made();
  const auto& blend = std::get<CyclicBlendBetween>(part(network, network.joints[0].part).shape);
  EXPECT_TRUE(blend.options.k);
  EXPECT_TRUE(blend.options.l);
  (void)solid(network);
}

TEST(PipingLine, rounds_olets_and_set_on_branches) {
  Line line;
  line.pipe({0, 0, 0}, {2000, 0, 0}).add(PipingShape::fitting, {{500, 0, 120}}, 25);
  line.last().center = Vec3(500, 0, 0);
  line.pipe({1500, 0, 50}, {1500, 0, 400}, 25);
  const PipingNetwork network = line.made({.fillet = 6});
  for (const char* name : {"c1-fillet", "c2-fillet"}) {
    EXPECT_EQ(std::get<FilletBetween>(part(network, name).shape).radius, 6);
  }
  (void)solid(network);
}

TEST(PipingLine, knows_the_components_of_its_parts) {
  Line line;
  line.tee({0, 0, 0}, {300, 0, 0}, {600, 0, 0}, {300, 0, 200});
  line.last().kind = "TEE";
  for (const Part& part : line.made().assembly.parts) {
    EXPECT_EQ(part.component.name, "c0");
    EXPECT_EQ(part.component.kind, "TEE");
    EXPECT_EQ(part.component.line, 10);
  }
}

TEST(PipingLine, closes_ends) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).add(PipingShape::closure, {{500, 0, 0}, {540, 0, 0}});
  line.add(PipingShape::closure, {{0, 0, 0}});
  line.last().ports[0].radius.reset();
  const PipingNetwork plain = line.made();
  EXPECT_TRUE(part(plain, "c1").solid);
  EXPECT_EQ(kind(part(plain, "c2").shape), "cap");
  EXPECT_EQ(plain.open_ends, 0);
  const PipingNetwork hollow = line.made({.wall = 5});
  EXPECT_EQ(std::get<PipeAlong>(part(hollow, "c2").shape).length, 5);
  const Built metal = build(hollow.assembly, {.tolerance = .5});
  EXPECT_EQ(metal.region, Region::metal);
  EXPECT_EQ(metal.solid.euler_number(), 4);  // a shell around a cavity
}

TEST(PipingLine, takes_radii_from_neighbours) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).pipe({500, 0, 0}, {600, 0, 0}).pipe({600, 0, 0}, {700, 0, 0});
  for (PipingPort& port : line.last().ports) {
    port.radius.reset();
  }
  const PipingNetwork network = line.made();
  EXPECT_THAT(notes(network),
              HasSubstr("30: c2: has no bore at line 31; its neighbours' radius 50 is taken"));
  (void)solid(network);
  Line alone;
  alone.pipe({0, 0, 0}, {1, 0, 0}).last().ports[0].radius.reset();
  alone.last().ports[1].radius.reset();
  alone.pipe({0, 0, 900}, {500, 0, 900});
  EXPECT_THROW((void)alone.made(), Error);
  EXPECT_EQ(alone.made({.keep_going = true}).assembly.parts.size(), 1);
}

TEST(PipingLine, takes_walls_from_neighbours_where_some_have_walls) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).pipe({500, 0, 0}, {600, 0, 0}).last().wall = 4;
  line.pipe({600, 0, 0}, {700, 0, 0}).pipe({0, 900, 0}, {500, 900, 0});
  const PipingNetwork network = line.made();
  EXPECT_EQ(part(network, "c0").wall, 4);
  EXPECT_EQ(part(network, "c2").wall, 4);
  EXPECT_FALSE(part(network, "c3").wall);  // joined to nothing
  EXPECT_THAT(notes(network), HasSubstr("10: c0: has no wall of its own, as 1 other component; "
                                        "those of their neighbours are taken"));
  EXPECT_EQ(part(line.made({.wall = 3}), "c1").wall, 4);
  EXPECT_FALSE(part(line.made({.wall = 3}), "c0").wall);  // the assembly's
}

TEST(PipingLine, has_closures_solid_whatever_wall_they_say_or_take) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).last().wall = 4;
  line.add(PipingShape::closure, {{500, 0, 0}, {540, 0, 0}}).last().wall = 4;
  line.add(PipingShape::closure, {{0, 0, 0}, {-40, 0, 0}});
  const PipingNetwork network = line.made();
  for (const char* name : {"c1", "c2"}) {
    EXPECT_TRUE(part(network, name).solid);
    EXPECT_FALSE(part(network, name).wall);
  }
  const Solid around = build(network.assembly, {.tolerance = .5}).solid;
  EXPECT_EQ(around.components(), 1);
  EXPECT_EQ(around.euler_number(), 4);  // two spheres, one around the void
}

TEST(PipingLine, lengthens_branches_that_end_on_a_wall) {
  Line line;
  line.pipe({0, 0, 0}, {1000, 0, 0}).pipe({500, 0, 50}, {500, 0, 300}, 20);
  const PipingNetwork network = line.made();
  EXPECT_THAT(notes(network),
              HasSubstr("20: c1: ends in the wall of c0; continued by 50 to its axis"));
  EXPECT_EQ(network.open_ends, 3);  // not the one in the wall
  (void)solid(network);
}

TEST(PipingLine, is_built_without_what_build_refuses_if_told_to_keep_going) {
  Line line;
  line.pipe({0, 0, 0}, {1000, 0, 0}).pipe({1000, 0, 0}, {1500, 0, 0}).last().wall = 70;
  line.pipe({1500, 0, 0}, {2000, 0, 0});
  PipingOptions options{.wall = 5};
  PipingNetwork network = line.made(options);
  EXPECT_EQ(network.origins, (std::vector<std::string>{"c0", "c1", "c2"}));
  EXPECT_THROW((void)build(line.line(), options, network), Error);
  options.keep_going = true;
  const Built built = build(line.line(), options, network);
  EXPECT_EQ(built.solid.components(), 2);
  EXPECT_EQ(network.assembly.parts.size(), 2);
  EXPECT_THAT(notes(network), HasSubstr("20: c1: left out, as a wall of 70 leaves no bore"));
  EXPECT_TRUE(network.notes.at(0).is_refusal);
}

TEST(PipingLine, closes_loops) {
  Line line;
  line.bend({-300, 0, 0}, {0, 0, 0}, {0, 300, 0}).pipe({0, 300, 0}, {0, 700, 0});
  line.bend({0, 700, 0}, {0, 1000, 0}, {-300, 1000, 0}).pipe({-300, 1000, 0}, {-700, 1000, 0});
  line.bend({-700, 1000, 0}, {-1000, 1000, 0}, {-1000, 700, 0})
      .pipe({-1000, 700, 0}, {-1000, 300, 0});
  line.bend({-1000, 300, 0}, {-1000, 0, 0}, {-700, 0, 0}).pipe({-700, 0, 0}, {-300, 0, 0});
  const PipingNetwork network = line.made();
  EXPECT_EQ(network.open_ends, 0);
  const Built built = build(network.assembly, {.tolerance = .5});
  EXPECT_EQ(built.solid.euler_number(), 0);
  EXPECT_EQ(built.solid.components(), 1);
}

TEST(PipingLine, refuses_what_is_no_component) {
  const auto what = [](const Line& line) {
    try {
      (void)line.made();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(what(Line().add(PipingShape::straight, {})),
              HasSubstr("a.pcf:10: 'c0': it has no end"));
  EXPECT_THAT(what(Line().add(PipingShape::straight, {{0, 0, 0}})),
              HasSubstr("one end instead of two"));
  EXPECT_THAT(what(Line().add(PipingShape::straight, {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}})),
              HasSubstr("3 ends instead of two"));
  EXPECT_THAT(what(Line().add(PipingShape::bend, {{0, 0, 0}, {1, 1, 0}})),
              HasSubstr("no centre point"));
  EXPECT_THAT(what(Line().bend({-300, 1, 0}, {0, 0, 0}, {-300, -1, 0})), HasSubstr("turns back"));
  EXPECT_THAT(what(Line()), HasSubstr("no component is left"));
  EXPECT_THROW((void)Line().pipe({0, 0, 0}, {9, 0, 0}).made({.snap = -1}), Error);
  EXPECT_THROW((void)Line().pipe({0, 0, 0}, {9, 0, 0}).made({.bridge = std::nan("")}), Error);
}

TEST(PipingLine, gives_its_ends_as_the_file_has_them) {
  Line line;
  line.pipe({0, 0, 0}, {1000, .03, 0}).pipe({1000, -.01, 0}, {2000, 0, 0}, 30);
  const auto all = ports(line.line());
  ASSERT_EQ(all.size(), 4);
  EXPECT_EQ(all[1].name, "c0.2");
  EXPECT_EQ(all[1].ring.center, Vec3(1000, .03, 0));
  EXPECT_EQ(all[2].ring.radius, 30);
  EXPECT_EQ(pair_ends(all, 1).size(), 3);
}

TEST(PipingLine, keeps_far_coordinates_exact) {
  const Vec3 far(212345.678, -187654.321, 98765.432);
  Line line;
  line.pipe(far, far + Vec3(777, 0, 0))
      .bend(far + Vec3(777, 0, 0), far + Vec3(877, 0, 0), far + Vec3(877, 100, 0));
  line.pipe(far + Vec3(877, 100, 0), far + Vec3(877, 900, 0));
  const PipingNetwork network = line.made();
  EXPECT_LT(network.largest_move, 1e-9);
  (void)solid(network);
}

}  // namespace
}  // namespace dupin::test
