#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blends/network/piping_line_builder.h"
#include "dupin/blends/build.h"
#include "dupin/blends/piping_line.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

TEST(PipingFittings, makes_tees_whose_centre_lies_off_the_run_or_whose_run_turns) {
  Line off;
  off.pipe({-900, 0, 0}, {-100, 0, 0}).tee({-100, 0, 0}, {0, 0, 3}, {100, 0, 0}, {0, 0, 100});
  off.pipe({100, 0, 0}, {900, 0, 0});
  EXPECT_EQ(kind(part(off.made(), "c1").shape), "pipe");
  (void)solid(off.made());
  for (const double aside : {2., 3., 5.}) {  // of short ones, by the pipe that goes on
    for (const bool is_open : {false, true}) {
      Line beside;
      beside.pipe({-300, 0, 0}, {-27, 0, 0}, 30)
          .tee({-27, 0, 0}, {0, 0, aside}, {27, 0, 0}, {0, 0, 75}, 30, 30);
      if (!is_open) {
        beside.pipe({27, 0, 0}, {300, 0, 0}, 30);
      }
      EXPECT_EQ(kind(part(beside.made(), "c1").shape), "pipe") << aside << is_open;
      EXPECT_EQ(notes(beside.made()), "") << aside << is_open;
      (void)solid(beside.made());
    }
  }
  Line turned;  // whose pipes lead to the centre
  turned.pipe({-900, 0, -27}, {-100, 0, 0})
      .tee({-100, 0, 0}, {0, 0, 3.375}, {100, 0, 0}, {0, 0, 100});
  turned.pipe({100, 0, 0}, {900, 0, -27});
  EXPECT_EQ(kind(part(turned.made(), "c1").shape), "elbow");
  (void)solid(turned.made());
}

TEST(PipingFittings, takes_the_arms_on_one_line_for_the_run_whatever_they_are_called) {
  Line line;
  line.tee({-100, 0, 0}, {0, 0, 0}, {0, 0, 100}, {100, 0, 0}, 50, 50);
  const PipingNetwork network = line.made();
  const auto& run = std::get<PipeBetween>(part(network, "c0").shape);
  EXPECT_EQ(run.from.z(), run.to.z());
  (void)solid(network);
}

TEST(PipingFittings, makes_crosses_and_stubs) {
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

TEST(PipingFittings, gives_fittings_that_turn_sharply_a_ball) {
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

TEST(PipingFittings, joins_the_arms_of_fittings_that_turn_sharply_whatever_their_length_and_wall) {
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

TEST(PipingFittings, gives_fittings_a_ball_whose_branch_is_thicker_than_their_run) {
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

TEST(PipingFittings, notes_open_ends_inside_of_a_ball) {
  Line line;
  line.add(PipingShape::fitting, {{0, 0, -52}, {52, 0, 0}}).last().center = Vec3::Zero();
  line.pipe({0, 0, -52}, {0, 0, -500});
  EXPECT_THAT(notes(line.made()),
              HasSubstr("10: c0: its end at line 12 lies inside of its ball of radius 52.5, and "
                        "opens nowhere\n"));
  line.pipe({52, 0, 0}, {500, 0, 0});
  EXPECT_EQ(notes(line.made()), "");
}

TEST(PipingFittings, notes_branches_without_length_and_branches_of_nothing) {
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

// As wide as the run, which ends before the branch does: of what the file says, no patch is.
TEST(PipingFittings, branches_that_reach_out_of_their_run_are_refused_for_that) {
  Line line;
  line.pipe({0, 0, 0}, {300, 0, 0})
      .tee({300, 0, 0}, {345, 0, 0}, {390, 0, 0}, {345, 0, 105}, 50, 50);
  PipingOptions options{.wall = 3};
  PipingNetwork network = line.made(options);
  try {
    (void)build(line.line(), options, network);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "a.pcf:20");
    EXPECT_THAT(error.message(), HasSubstr("its end 'c1-branch.start' is to lie inside of what it "
                                           "branches off, and reaches out of that"));
    EXPECT_THAT(error.message(), testing::Not(HasSubstr("another name")));
  }
}

}  // namespace
}  // namespace dupin::test
