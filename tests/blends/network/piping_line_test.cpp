#include "dupin/blends/piping_line.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blends/network/piping_line_builder.h"
#include "dupin/blends/build.h"
#include "dupin/blends/resolve.h"
#include "dupin/kernel/error.h"

namespace dupin::test {
namespace {

using testing::HasSubstr, testing::Not;

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
  const PipingNetwork network = line.made();
  EXPECT_EQ(kind(part(network, "c0").shape), "pipe");
  EXPECT_THAT(notes(network), HasSubstr("10: c0: does not turn"));
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

TEST(PipingLine, says_why_a_blend_takes_the_place_of_a_bend) {
  Line line;
  line.pipe({-900, .1, 0}, {-300, .1, 0}).bend({-300, 0, 0}, {0, 0, 0}, {0, 300, 0});
  line.pipe({0, 300, 0}, {0, 900, 0});
  const PipingNetwork network = line.made({.bridge = 0.5});
  EXPECT_EQ(kind(part(network, "c1").shape), "cyclic_blend");
  EXPECT_THAT(notes(network), HasSubstr("20: c1: lies apart from its neighbours"));
  EXPECT_THAT(notes(network), Not(HasSubstr("is not tangent"))) << "it is";
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
    EXPECT_EQ(error.code(), Errc::irregular_surface);
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

TEST(PipingLine, keeps_eccentric_parts_flat) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).add(PipingShape::straight, {{500, 0, 0}, {600, 0, 20}});
  line.last().is_eccentric = true;
  line.last().ports[1].radius = 30;
  line.pipe({600, 0, 20}, {1200, 0, 20}, 30)
      .bend({1200, 0, 20}, {1300, 0, 20}, {1300, 100, 20}, 30);
  const PipingNetwork network = line.made();
  EXPECT_EQ(kind(part(network, "c1").shape), "oblique");
  EXPECT_THAT(notes(network), Not(HasSubstr("flat side")));
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

TEST(PipingLine, keeps_eccentric_parts_in_a_row_flat) {
  struct Row {
    std::vector<double> heights, radii;
    bool has_before = true, has_after = true;
  };
  const std::vector<Row> rows{{{0, 20, 35}, {50, 30, 15}},  // as one would: flat below
                              {{0, -20, -35, -40}, {50, 30, 15, 10}},
                              {{0, 20, 5}, {50, 30, 15}},   // flat below, then above
                              {{0, 20, 40}, {50, 30, 10}},  // of one slant
                              {{0, 20, 0}, {30, 50, 30}},
                              {{0, 20, 35}, {50, 30, 15}, true, false},
                              {{0, 20, 35}, {50, 30, 15}, false, true}};
  for (const auto& [heights, radii, has_before, has_after] : rows) {
    SCOPED_TRACE(testing::PrintToString(heights) + (has_before ? " behind" : "") +
                 (has_after ? " before" : ""));
    const std::size_t reducers = heights.size() - 1;
    const double end = 100 * double(reducers);
    Line line;
    if (has_before) {
      line.pipe({-500, 0, 0}, {0, 0, 0}, radii.front());
    }
    double volume = 0;
    for (std::size_t i = 0; i < reducers; ++i) {
      line.add(PipingShape::straight,
               {{100 * double(i), 0, heights[i]}, {100 * double(i + 1), 0, heights[i + 1]}},
               radii[i]);
      line.last().is_eccentric = true;
      line.last().ports[1].radius = radii[i + 1];
      volume += std::numbers::pi * 100 / 3 *
                (radii[i] * radii[i] + radii[i] * radii[i + 1] + radii[i + 1] * radii[i + 1]);
    }
    if (has_after) {
      line.pipe({end, 0, heights.back()}, {end + 500, 0, heights.back()}, radii.back());
    }
    const PipingNetwork network = line.made();
    EXPECT_EQ(network.assembly.parts.size(), reducers + has_before + has_after);
    EXPECT_EQ(network.largest_move, 0);
    EXPECT_EQ(notes(network), "");
    for (std::size_t i = 0; i < reducers; ++i) {
      EXPECT_EQ(kind(part(network, "c" + std::to_string(i + has_before)).shape), "oblique");
    }
    for (const PipingJoint& joint : network.joints) {
      EXPECT_EQ(joint.state, JointState::met);
    }
    volume +=
        std::numbers::pi * 500 *
        (has_before * radii.front() * radii.front() + has_after * radii.back() * radii.back());
    EXPECT_NEAR(solid(network).volume(), volume, 0.02 * volume);
  }
}

TEST(PipingLine, makes_cones_of_what_leads_along_the_axis_between_eccentric_parts) {
  Line line;
  line.pipe({-500, 0, 0}, {0, 0, 0});
  const auto reducer = [&](const Vec3& from, const Vec3& to, double radius, double next) {
    line.add(PipingShape::straight, {from, to}, radius).last().is_eccentric = true;
    line.last().ports[1].radius = next;
    line.last().kind = from.z() == to.z() ? "REDUCER-CONCENTRIC" : "REDUCER-ECCENTRIC";
  };
  reducer({0, 0, 0}, {100, 0, 10}, 50, 40);
  reducer({100, 0, 10}, {200, 0, 10}, 40, 30);
  reducer({200, 0, 10}, {300, 0, 20}, 30, 20);
  line.pipe({300, 0, 20}, {400, 0, 20}, 20);
  reducer({400, 0, 20}, {500, 0, 20}, 20, 30);
  line.pipe({500, 0, 20}, {900, 0, 20}, 30);
  const PipingNetwork network = line.made();
  std::vector<std::string_view> kinds;
  for (const Part& part : network.assembly.parts) {
    kinds.push_back(kind(part.shape));
  }
  EXPECT_EQ(kinds, (std::vector<std::string_view>{"pipe", "oblique", "cone", "oblique", "pipe",
                                                  "cone", "pipe"}));
  EXPECT_EQ(notes(network), "") << "concentric is what they are called";
  (void)solid(network);
}

TEST(PipingLine, notes_eccentric_parts_in_a_row_that_nothing_tells_the_axis_of) {
  Line line;
  line.add(PipingShape::straight, {{0, 0, 0}, {100, 0, 20}}).last().is_eccentric = true;
  line.last().ports[1].radius = 30;
  line.add(PipingShape::straight, {{100, 0, 20}, {200, 0, 50}}, 30).last().is_eccentric = true;
  line.last().ports[1].radius = 10;
  const PipingNetwork network = line.made();
  EXPECT_THAT(notes(network), HasSubstr("10: c0: has no flat side"));
  EXPECT_THAT(notes(network), HasSubstr("20: c1: has no flat side"));
  (void)solid(network);
}

TEST(PipingLine, notes_eccentric_parts_that_have_no_flat_side) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).add(PipingShape::straight, {{500, 0, 0}, {600, 0, 0}});
  line.last().is_eccentric = true;
  line.last().ports[1].radius = 30;
  line.pipe({600, 0, 0}, {1200, 0, 0}, 30);
  const PipingNetwork network = line.made();
  EXPECT_THAT(kind(part(network, "c1").shape), HasSubstr("cone"));
  EXPECT_THAT(notes(network), HasSubstr("20: c1: has no flat side"));
  (void)solid(network);
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
  Line single;
  single.pipe({0, 0, 0}, {500, 0, 0}).last().ports[1].radius.reset();
  EXPECT_THAT(notes(single.made()), HasSubstr("the radius of another of its ends, 50, is taken"));
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
  EXPECT_THAT(what(Line().pipe({0, 0, 0}, {9, 0, std::nan("")})), HasSubstr("must be finite"));
  EXPECT_THAT(what(Line().pipe({0, 0, 0}, {9, 0, INFINITY})), HasSubstr("must be finite"));
  for (const double bad : {-1.0, std::nan(""), double(INFINITY)}) {
    for (const PipingOptions& options : std::vector<PipingOptions>{
             {.tolerance = bad}, {.wall = bad}, {.insulation = bad}, {.fillet = bad}}) {
      EXPECT_THROW((void)Line().pipe({0, 0, 0}, {9, 0, 0}).made(options), Error);
    }
  }
  EXPECT_THROW((void)Line().pipe({0, 0, 0}, {9, 0, 0}).made({.snap = -1}), Error);
  EXPECT_THROW((void)Line().pipe({0, 0, 0}, {9, 0, 0}).made({.bridge = std::nan("")}), Error);
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
