#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blends/network/piping_line_builder.h"
#include "dupin/blends/build.h"
#include "dupin/blends/piping_line.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

constexpr double kRadius = 50, kWall = 4;

struct Branched {
  std::string name;
  Line line;
  std::size_t open_ends = 3;
};

Line& fitting(Line& line, std::initializer_list<Vec3> ports, double branch,
              const Vec3& center = Vec3::Zero()) {
  line.add(PipingShape::fitting, ports, kRadius).last().center = center;
  for (std::size_t i = ports.size() > 1 ? 2 : 0; i < ports.size(); ++i) {
    line.last().ports[i].radius = branch;
  }
  return line;
}

Line& teed_bend(Line& line, const Vec3& branch, double radius) {
  line.add(PipingShape::bend, {{-150, 0, 0}, {0, 150, 0}, branch}, kRadius).last().center =
      Vec3::Zero();
  line.last().ports[2].radius = radius;
  return line;
}

// Every kind of branch, of that radius.
std::vector<Branched> branched(double branch) {
  std::vector<Branched> all(13);
  auto next = [&all, i = std::size_t{0}](const std::string& name) mutable -> Line& {
    all[i].name = name;
    return all[i++].line;
  };
  const Vec3 from{-110, 0, 0}, to{110, 0, 0};
  fitting(next("tee"), {from, to, {0, 110, 0}}, branch);
  Line& joined = fitting(next("tee with pipes"), {from, to, {0, 110, 0}}, branch);
  joined.pipe({-600, 0, 0}, from).pipe({0, 110, 0}, {0, 500, 0}, branch);
  fitting(next("tee off its run"), {from, to, {0, 110, 0}}, branch, {0, 3, 0});
  fitting(next("tee beside its run"), {from, to, {0, 110, .02}}, branch, {0, -3, .02});
  fitting(next("y"), {{-200, 0, 0}, {200, 0, 0}, {150, 150, 0}}, branch);
  fitting(next("cross"), {from, to, {0, 110, 0}, {0, -110, 0}}, branch);
  fitting(next("two branches"), {from, to, {0, 110, 0}, {0, 0, 110}}, branch);
  Line& olet = next("olet").pipe({-300, 0, 0}, {300, 0, 0});
  fitting(olet, {{0, 130, 0}}, branch);
  Line& stub = next("stub off the axis").pipe({-300, 0, 0}, {300, 0, 0});
  fitting(stub, {{100, 160, 0}}, branch, {0, 10, 0});
  next("set on").pipe({-300, 0, 0}, {300, 0, 0}).pipe({0, 30, 0}, {0, 300, 0}, branch);
  teed_bend(next("bend, leg"), {400, 0, 0}, branch);
  teed_bend(next("bend, back"), {200, -200, 0}, branch);
  teed_bend(next("bend, aside"), {-44, 44, 300}, branch);
  all[5].open_ends = all[6].open_ends = 4;
  return all;
}

PipingLine turned(PipingLine line, const Eigen::Quaterniond& by, const Vec3& offset) {
  for (PipingComponent& component : line.components) {
    for (PipingPort& port : component.ports) {
      port.center = by * port.center + offset;
    }
    if (component.center) {
      component.center = by * *component.center + offset;
    }
  }
  return line;
}

// Of patches that are called like an end.
std::map<std::string, double> areas_of_ends(const Solid& solid) {
  std::map<std::string, double> result;
  const auto& points = solid.nearest_points();
  for (std::size_t i = 0; i < solid.triangle_count(); ++i) {
    const std::string& name = solid.names()[solid.labels()[i]];
    if (name.ends_with(".start") || name.ends_with(".end")) {
      const auto& [a, b, c] = solid.triangles()[i];
      result[name] += (points[b] - points[a]).cross(points[c] - points[a]).norm() / 2;
    }
  }
  return result;
}

double disc(double radius) { return std::numbers::pi * radius * radius; }

void expect_open_ends(const Branched& made, const PipingNetwork& network, double branch,
                      double tolerance) {
  EXPECT_EQ(network.open_ends, made.open_ends) << made.name;
  for (const Region region : {Region::outer, Region::metal, Region::fluid}) {
    const Built built = build(network.assembly, {.tolerance = tolerance, .region = region});
    const auto ends = areas_of_ends(built.solid);
    EXPECT_EQ(ends.size(), made.open_ends) << made.name << " of " << branch;
    EXPECT_EQ(built.solid.components(), 1) << made.name;
    const double bore = disc(branch - kWall);
    const double least = region == Region::outer   ? disc(branch)
                         : region == Region::metal ? disc(branch) - bore
                                                   : bore;
    for (const auto& [name, area] : ends) {
      EXPECT_GT(area, .9 * least) << made.name << ": " << name;
    }
    for (const GapPair& gap : built.gaps) {
      EXPECT_TRUE(gap.report.verdict == GapVerdict::welded ||
                  gap.report.verdict == GapVerdict::open)
          << made.name << ": " << built.ports[gap.first].name;
    }
  }
}

// The end inside of the run of one as thick as that touches its surface, so that a mesh of it may
// stick out of the run's; it must not be taken for an end of the line.
TEST(PipingOpenEnds, are_all_patches_that_are_called_like_an_end) {
  for (const double branch : {1 * kRadius, .9995 * kRadius, .98 * kRadius}) {
    int turn = 0;
    for (const Branched& made : branched(branch)) {
      for (const double tolerance : {.2, 1.}) {
        ++turn;
        const Eigen::Quaterniond by(Eigen::AngleAxisd(.7 * turn, Vec3(1, 2, turn).normalized()));
        const PipingLine line = turned(made.line.line(), by, {212345.678, 98765.432, 12345.678});
        expect_open_ends(made, assembly_of(line, {.wall = kWall}), branch, tolerance);
      }
    }
  }
}

TEST(PipingOpenEnds, of_branches_of_nothing_and_thicker_than_their_run_are_said) {
  Line stray;
  stray.pipe({-300, 0, 0}, {300, 0, 0});
  fitting(stray, {{0, 700, 0}}, 20, {0, 500, 0});
  EXPECT_EQ(stray.made().open_ends, 4);
  EXPECT_EQ(areas_of_ends(build(stray.made().assembly, {}).solid).size(), 4);
  Line thick;
  thick.pipe({-300, 0, 0}, {300, 0, 0});
  fitting(thick, {{0, 300, 0}}, 70);
  thick.pipe({200, 40, 0}, {200, 300, 0}, 60);
  const PipingNetwork network = thick.made();
  EXPECT_THAT(notes(network), testing::HasSubstr("20: c1: is thicker than c0, in which it ends, "
                                                 "and sticks out of it there\n"));
  EXPECT_THAT(notes(network), testing::HasSubstr("30: c2: is thicker than c0"));
  EXPECT_EQ(network.open_ends, 6);
  EXPECT_EQ(areas_of_ends(build(network.assembly, {}).solid).size(), 6);
}

// Whose branch reaches back over the pipe's open end, which lies in it only in part.
TEST(PipingOpenEnds, pieces_without_length_say_whether_their_neighbours_are_joined) {
  const auto chain = [](int pieces) {
    Line line;
    line.pipe({0, 0, 0}, {500, 0, 0});
    for (int i = 0; i < pieces; ++i) {
      line.pipe({500 + .04 * i, 0, 0}, {500 + .04 * (i + 1), 0, 0});
    }
    return notes(line.pipe({500 + .04 * pieces, 0, 0}, {900, 0, 0}).made());
  };
  EXPECT_EQ(chain(1),
            "20: c1: has no length beyond the snap tolerance; its neighbours are joined\n");
  EXPECT_THAT(chain(20), testing::Not(testing::HasSubstr("joined")));
  EXPECT_THAT(chain(20), testing::HasSubstr("210: c20: has no length beyond the snap tolerance; "
                                            "nothing is made of it\n"));
}

TEST(PipingOpenEnds, caps_that_are_solid_have_no_wall_to_take) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).last().wall = 5;
  line.add(PipingShape::closure, {{500, 0, 0}, {550, 0, 0}});
  EXPECT_EQ(notes(line.made()), "");
  line.pipe({-500, 0, 0}, {0, 0, 0});
  EXPECT_EQ(notes(line.made()),
            "30: c2: has no wall of its own; those of their neighbours are taken\n");
}

TEST(PipingOpenEnds, bends_say_where_their_legs_are_too_short_for_their_radius) {
  Line line;
  line.bend({0, 0, 0}, {300, 0, 0}, {300, 300, 0}).last().bend_radius = 400;
  EXPECT_EQ(notes(line.made()),
            "10: c0: its legs are too short for its bend radius of 400; it has one of 300\n");
  line.last().bend_radius = 301;
  EXPECT_EQ(notes(line.made()), "");
}

// 150 (sqrt(2) - 1) inside of the corner is the middle of the arc; 50 further out is its wall.
TEST(PipingOpenEnds, olets_on_the_wall_of_a_bend_are_continued_to_its_axis) {
  const Vec3 out = Vec3(1, -1, 0).normalized(), corner(150, 0, 0);
  const Vec3 middle = corner - 150 * (std::sqrt(2.) - 1) * out;
  for (const double height : {40., 50., 50.04, 50.06}) {
    Line line;
    line.bend({0, 0, 0}, corner, {150, 150, 0}).add(PipingShape::fitting, {middle + 130 * out}, 15);
    line.last().center = middle + height * out;
    const PipingNetwork network = line.made();
    const bool is_in = height < 50.05;
    EXPECT_EQ(network.open_ends, is_in ? 3 : 4) << height;
    EXPECT_THAT(notes(network), testing::HasSubstr(is_in ? "its branch is continued by"
                                                         : "lies in no other component"));
    (void)solid(network, is_in ? 1 : 2);
  }
}

// On the wall, or beyond it by less than the snap tolerance, as a pipe that is set on there.
TEST(PipingOpenEnds, olets_on_a_wall_are_continued_to_the_axis) {
  for (const double height : {40., 49.9, 50., 50.04}) {
    Line line;
    line.pipe({-300, 0, 0}, {300, 0, 0}).add(PipingShape::fitting, {{20, 130, 0}}, 15);
    line.last().center = Vec3(20, height, 0);
    const PipingNetwork network = line.made();
    EXPECT_EQ(network.open_ends, 3);
    EXPECT_THAT(notes(network),
                testing::HasSubstr("lies in the wall of c0; its branch is continued by"));
    (void)solid(network);
  }
  Line far;
  far.pipe({-300, 0, 0}, {300, 0, 0}).add(PipingShape::fitting, {{20, 130, 0}}, 15);
  far.last().center = Vec3(20, -50, 0);
  EXPECT_THAT(notes(far.made()), testing::HasSubstr("shortened by 50 to its axis"));
  far.last().center = Vec3(20, 50.06, 0);
  EXPECT_EQ(far.made().open_ends, 4);
  EXPECT_THAT(notes(far.made()), testing::HasSubstr("lies in no other component"));
  Line aside;
  aside.pipe({-300, 0, 0}, {300, 0, 0}).add(PipingShape::fitting, {{20, 130, 45}}, 15);
  aside.last().center = Vec3(20, 0, 45);
  EXPECT_THAT(notes(aside.made()), testing::HasSubstr("begins in c0 only in part"));
}

Line olet_beside_end(double end) {
  Line line;
  line.pipe({end, 0, 0}, {200, 0, 0});
  line.add(PipingShape::fitting, {{22, 68, 73}}).last().center = Vec3(50, 0, 0);
  return line;
}

TEST(PipingOpenEnds, the_branch_beside_an_end_is_refused_and_not_the_pipe) {
  const Line line = olet_beside_end(0);
  PipingOptions options{.wall = 4};
  PipingNetwork network = line.made(options);
  EXPECT_THAT(notes(network), HasSubstr("c0: its end lies in c1 only in part"));
  try {
    (void)build(line.line(), options, network);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "a.pcf:20");
    EXPECT_THAT(error.message(), HasSubstr("an open end of 'c0' is cut; that end must be "
                                           "elsewhere, or no walls be given; --keep-going"));
  }
  options.keep_going = true;
  network = line.made(options);
  (void)build(line.line(), options, network);
  ASSERT_EQ(network.assembly.parts.size(), 1U);
  EXPECT_EQ(network.assembly.parts[0].name, "c0");
  EXPECT_THAT(notes(network), HasSubstr("20: c1: left out"));
  const Line elsewhere = olet_beside_end(-60);  // as it says
  PipingNetwork further = elsewhere.made({.wall = 4});
  EXPECT_EQ(build(elsewhere.line(), {.wall = 4}, further).solid.components(), 1);
  PipingNetwork solid = line.made();
  EXPECT_EQ(build(line.line(), {}, solid).solid.components(), 1);
}

// Nobody wrote a document that would have its pointers and keys.
TEST(PipingOpenEnds, faults_of_a_line_are_at_its_lines_and_say_nothing_of_a_document) {
  Line line;
  line.pipe({0, 0, 0}, {200, 0, 0});
  PipingNetwork network = line.made();
  const auto refusal = [&](const BuildOptions& options) {
    try {
      (void)build(line.line(), {}, network, options);
    } catch (const Error& error) {
      return error.where() + ": " + error.message();
    }
    return std::string();
  };
  EXPECT_EQ(refusal({.region = Region::metal}),
            "a.pcf: there is no metal region: nothing says how thick a wall is; --wall does");
  EXPECT_EQ(refusal({.region = Region::insulation}),
            "a.pcf: there is no insulation region: nothing says how thick insulation is; "
            "--insulation does");
  const std::string costly = refusal({.tolerance = 1e-7, .most_triangles = 1000});
  EXPECT_TRUE(costly.starts_with("a.pcf:10: ")) << costly;
  EXPECT_THAT(costly, testing::Not(HasSubstr("--keep-going")));  // which would not help
  network.assembly.wall = 4;
  EXPECT_EQ(build(line.line(), {}, network, {.region = Region::metal}).solid.components(), 1);
}

}  // namespace
}  // namespace dupin::test
