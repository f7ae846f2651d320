#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blends/network/piping_line_builder.h"
#include "dupin/blends/resolve.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

// How far the end is from the nearest ring of its component's parts.
double move_of(const PipingPort& end, const std::string& component, const ResolvedAssembly& made) {
  double nearest = INFINITY;
  for (const Port& port : ports(made)) {
    if (port.part == component || port.part.starts_with(component + "-")) {
      nearest = std::min(nearest, (port.ring.center - end.center).norm());
    }
  }
  return nearest;
}

double furthest_move(const Line& line, const PipingNetwork& network) {
  const ResolvedAssembly made = resolve(network.assembly);
  double furthest = 0;
  for (const PipingComponent& component : line.line().components) {
    for (const PipingPort& end : component.ports) {
      furthest = std::max(furthest, move_of(end, component.name, made));
    }
  }
  return furthest;
}

bool have_all_met(const PipingNetwork& network) {
  return std::ranges::all_of(
      network.joints, [](const PipingJoint& joint) { return joint.state == JointState::met; });
}

void eccentric(Line& line, const Vec3& from, const Vec3& to, double radius, double next) {
  line.pipe(from, to, radius).last().is_eccentric = true;
  line.last().ports[1].radius = next;
}

TEST(PipingMoves, are_those_of_ends_beside_bends_with_unequal_legs) {
  Line line;
  line.pipe({0, 0, 0}, {1000, 0, 0}).bend({1000, 0, 0}, {1152.1, 0, 0}, {1152.1, 152, 0});
  const PipingNetwork network = line.made();
  EXPECT_NEAR(network.largest_move, .05, 1e-9);
  EXPECT_NEAR(furthest_move(line, network), .05, 1e-9);
}

TEST(PipingMoves, stay_within_the_snap_tolerance_where_axes_take_the_ends_of_bends_aside) {
  Line line;
  line.pipe({0, .04, 0}, {500, .04, 0})
      .pipe({500, .04, 0}, {1000, .04, 0})
      .bend({1000, .04, 0}, {1100, 0, 0}, {1100, 99.91, 0});
  line.pipe({1100, 99.91, 0}, {1100, 600, 0});
  const PipingNetwork network = line.made();
  EXPECT_LE(network.largest_move, .05 + 1e-9);
  EXPECT_NEAR(furthest_move(line, network), network.largest_move, 1e-9);
}

TEST(PipingMoves, are_those_of_what_goes_on_where_a_part_is_too_short_between_bends) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).bend({500, 0, 0}, {600, 0, 0}, {600, 100, 0});
  line.bend({600, 100.04, 0}, {600, 200.04, 0}, {700, 200.04, 0});
  line.pipe({700, 200.04, 0}, {1200, 200.04, 0});
  const PipingNetwork network = line.made();
  EXPECT_GT(network.largest_move, .01);
  EXPECT_NEAR(furthest_move(line, network), network.largest_move, 1e-9);
}

TEST(PipingMoves, are_those_of_plates) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).add(PipingShape::closure, {{500.03, 0, 0}});
  EXPECT_NEAR(line.made().largest_move, .03, 1e-9);
}

TEST(PipingMoves, are_never_more_than_is_said) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-1, 1);
  int moved = 0;
  for (int round = 0; round < 300; ++round) {
    const double snap = round % 3 == 0 ? .05 : .5, by = .4 * snap;
    const auto near = [&](double x, double y, double z) {
      return Vec3(x + by * off(random), y + by * off(random), z + by * off(random));
    };
    Line line;
    line.pipe(near(0, 0, 0), near(400, 0, 0)).pipe(near(400, 0, 0), near(900, 0, 0));
    line.bend(near(900, 0, 0), near(1000, 0, 0), near(1000, 100, 0));
    if (round % 2 == 0) {
      line.pipe(near(1000, 100, 0), near(1000, 400, 0));
    } else {
      eccentric(line, near(1000, 100, 0), near(1000, 200, 20), 50, 30);
      line.pipe(near(1000, 200, 20), near(1000, 500, 20), 30);
    }
    const PipingNetwork network = line.made({.snap = snap});
    if (have_all_met(network)) {  // nothing is set back
      const double furthest = furthest_move(line, network);
      EXPECT_LE(furthest, network.largest_move + 1e-9) << round;
      EXPECT_LE(furthest, 1.5 * snap) << round;
      moved += furthest > .1 * snap;
    }
  }
  EXPECT_GT(moved, 50);
}

// Their circles lie where their neighbours begin, so that what goes on from them is on its axis.
TEST(PipingMoves, leave_what_goes_on_from_eccentric_parts_on_its_axis) {
  Line bend;
  eccentric(bend, {4863.3, .1, 573}, {4890, 4.1, 657.4}, 30, 57);
  bend.bend({4889.8, 4.5, 657.7}, {4889.8, 4.5, 1000.6}, {5232.7, 4.5, 1000.6}, 57);
  const PipingNetwork network = bend.made({.snap = 1});
  EXPECT_EQ(kind(part(network, "c0").shape), "oblique");
  EXPECT_NEAR(network.largest_move, std::sqrt(.2 * .2 + .4 * .4 + .3 * .3), 1e-9);
  EXPECT_NEAR(furthest_move(bend, network), network.largest_move, 1e-9);
  EXPECT_NEAR(
      (std::get<ElbowCorner>(part(network, "c1").shape).to - Vec3(5232.7, 4.5, 1000.6)).norm(), 0,
      1e-9);
  (void)solid(network);
  Line gap;  // along the axis, and beside it
  gap.pipe({-500, 0, 0}, {0, 0, 0});
  eccentric(gap, {.3, .1, 0}, {150, 0, -20}, 50, 30);
  gap.pipe({150.3, .1, -20}, {900, .1, -20}, 30);
  const PipingNetwork bridged = gap.made({.snap = .2, .bridge = 1});
  EXPECT_EQ(kind(part(bridged, "c1").shape), "oblique");
  EXPECT_NEAR(bridged.largest_move, .1, 1e-9);
  (void)solid(bridged);
}

// The longer one says the direction of both.
TEST(PipingMoves, are_small_at_the_far_ends_of_pipes_beside_eccentric_parts) {
  for (const bool is_first : {true, false}) {
    Line line;
    const Vec3 end(-100, .08, 0), far(10150, 0, -20);
    if (is_first) {
      line.pipe(end, {0, 0, 0});
    }
    eccentric(line, {0, 0, 0}, {150, 0, -20}, 50, 30);
    line.pipe({150, 0, -20}, far, 30);
    if (!is_first) {
      line.pipe({0, 0, 0}, end);
    }
    const PipingNetwork network = line.made();
    EXPECT_EQ(kind(part(network, is_first ? "c1" : "c0").shape), "oblique");
    EXPECT_NEAR(network.largest_move, .04, 1e-4);
    EXPECT_NEAR(furthest_move(line, network), network.largest_move, 1e-9);
  }
}

// Each pipe may be turned, but not both with the same axis.
TEST(PipingMoves, are_not_made_for_circles_of_eccentric_parts_to_be_parallel) {
  for (const double tilt : {.04, .15}) {
    Line line;
    line.pipe({-2000, tilt, 0}, {-1000, tilt / 2, 0}).pipe({-1000, tilt / 2, 0}, {0, 0, 0});
    eccentric(line, {0, 0, 0}, {150, 0, -20}, 50, 30);
    line.pipe({150, 0, -20}, {10150, 0, -20}, 30);
    const PipingNetwork network = line.made();
    EXPECT_EQ(kind(part(network, "c2").shape), tilt < .1 ? "oblique" : "cone");
    EXPECT_LE(network.largest_move, .05);
    (void)solid(network);
  }
}

TEST(PipingMoves, may_be_as_large_as_the_snap_tolerance_beside_eccentric_parts) {
  for (const double at : {0., 4890., 123456.}) {
    Line line;
    eccentric(line, {at, .1, 573}, {at + 30, .1, 657.4}, 30, 57);
    line.pipe({at + 30, .2, 657.4}, {at + 30, .2, 1657.4}, 57);
    const PipingNetwork network = line.made({.snap = .2 - .1});
    EXPECT_EQ(kind(part(network, "c0").shape), "oblique") << at;
    EXPECT_NEAR(network.largest_move, .1, 1e-9);
  }
}

// A concentric reducer may be one of those in a row.
TEST(PipingMoves, keep_rows_of_reducers_on_the_axis_that_follows) {
  Line line;
  eccentric(line, {0, 0, 0}, {120, 0, 50}, 57, 110);
  eccentric(line, {120, 0, 50}, {270, 0, 50}, 110, 30);
  line.pipe({270, .01, 50}, {2000, 0, 50}, 30);
  const PipingNetwork network = line.made();
  EXPECT_EQ(kind(part(network, "c0").shape), "oblique");
  (void)solid(network);
}

TEST(PipingMoves, are_noted_where_reducers_do_not_reduce) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0});
  eccentric(line, {500, 0, 0}, {600, 0, 12.7}, 50, 50);
  line.last().kind = "REDUCER-ECCENTRIC";
  line.pipe({600, 0, 12.7}, {1200, 0, 12.7});
  EXPECT_THAT(notes(line.made()), HasSubstr("20: c1: has the same bore at both ends, 12.7 beside "
                                            "each other; a slanted pipe takes its place"));
  Line along;
  eccentric(along, {500, 0, 0}, {600, 0, 0}, 50, 50);
  along.last().kind = "REDUCER-CONCENTRIC";
  EXPECT_THAT(notes(along.made()),
              HasSubstr("10: c0: has the same bore at both ends; a pipe takes its place"));
}

}  // namespace
}  // namespace dupin::test
