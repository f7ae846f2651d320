#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/bore.h"
#include "blends/assembly/hollow_regions.h"
#include "dupin/kernel/error.h"
#include "support/named_parts.h"

namespace dupin::assembly {
namespace {

using test::built;
using test::fillet;
using test::pipe;
using test::Regions;
using test::regions;
using testing::HasSubstr;
using testing::IsSupersetOf;

constexpr double kPi = std::numbers::pi;

Assembly walled(std::vector<Part> parts, double wall, double tolerance = 0.02) {
  return {"", Unit::millimetre, tolerance, {}, std::move(parts), wall};
}

std::set<std::string> names(const Solid& solid) {
  std::set<std::string> result;
  for (const auto label : solid.labels()) {
    result.insert(solid.names()[label]);
  }
  return result;
}

Part part(const std::string& name, PartShape shape, std::optional<double> wall = {},
          bool solid = false) {
  return {name, std::move(shape), wall, solid};
}

std::vector<Part> tee(double wall, double ball) {
  return {pipe("run", {-40, 0, 0}, {40, 0, 0}, 10 - wall),
          pipe("branch", {0, 0, 0}, {3, 6, 35}, 6 - wall), fillet("fillet", "run", "branch", ball)};
}

TEST(Bore, of_a_pipe_has_the_inner_cylinder_and_rims) {
  const Regions made = regions(walled({pipe("a", {1, 2, 3}, {7, 11, 21}, 2)}, 0.25, 0.001));
  const double length = 21, area = kPi * (4 - 1.75 * 1.75);
  EXPECT_NEAR(made.metal.solid.volume(), area * length, 0.001 * 2 * kPi * 4 * length);
  EXPECT_EQ(made.metal.solid.euler_number(), 0);
  EXPECT_EQ(made.fluid.solid.euler_number(), 2);
  EXPECT_EQ(names(made.metal.solid), (std::set<std::string>{"a", "a.bore", "a.start", "a.end"}));
  EXPECT_EQ(names(made.fluid.solid), (std::set<std::string>{"a.bore", "a.start", "a.end"}));
}

TEST(Bore, of_a_filleted_tee_is_the_tee_of_the_inner_radii_and_a_larger_ball) {
  const double wall = 1.5, tolerance = 0.005;
  const Regions made = regions(walled(tee(0, 3), wall, tolerance));
  EXPECT_EQ(made.metal.solid.euler_number(), -2);
  EXPECT_EQ(made.fluid.solid.euler_number(), 2);
  Assembly inner = walled(tee(wall, 3 + wall), 0, tolerance);
  inner.wall.reset();
  const Built by_itself = build(inner);
  EXPECT_NEAR(made.fluid.solid.volume(), by_itself.solid.volume(),
              2 * tolerance * by_itself.solid.area());
  EXPECT_THAT(names(made.fluid.solid), IsSupersetOf({"run.bore", "branch.bore", "fillet.bore"}));
}

// Oblique, beside the axis, as thick as the run: from one call both sides, or what would do.
TEST(Bore, of_tees_in_all_positions_is_a_larger_balls_or_says_what_would_do) {
  int bores = 0, refusals = 0;
  for (const double branch : {3.0, 6.0}) {
    for (const double aside : {0.0, 1.5}) {
      for (const double degrees : {90.0, 60.0, 45.0}) {
        for (const double wall : {0.4, 1.2, 2.0}) {
          const double angle = degrees * kPi / 180, radius = 0.4;
          const Vec3 along(std::cos(angle), std::sin(angle), 0), at(0, 0, aside);
          // Beside the axis one as thick leaves the run: it has to pass through then.
          const bool passes = aside + branch > 6;
          const auto document = [&](double thickness, double ball) {
            return walled(
                {pipe("run", {-40, 0, 0}, {40, 0, 0}, 6),
                 pipe("branch", passes ? Vec3(at - 35 * along) : at, at + 35 * along, branch),
                 fillet("fillet", "run", "branch", ball)},
                thickness);
          };
          SCOPED_TRACE(testing::Message()
                       << branch << ' ' << aside << ' ' << degrees << ' ' << wall);
          try {
            const Regions made = regions(document(wall, radius));
            EXPECT_THAT(names(made.fluid.solid),
                        IsSupersetOf({"run.bore", "branch.bore", "fillet.bore"}));
            EXPECT_THAT(names(made.metal.solid), IsSupersetOf({"fillet", "fillet.bore"}));
            EXPECT_EQ(made.fluid.solid.components(), 1);
            ++bores;
          } catch (const Error& error) {
            const std::string why = error.what();
            EXPECT_THAT(why, HasSubstr("inside, where the ball has a radius of"));
            const auto wall_at = why.find("a wall of "), ball_at = why.find("a fillet of radius ");
            EXPECT_TRUE(wall_at != std::string::npos || ball_at != std::string::npos) << why;
            if (wall_at != std::string::npos) {
              (void)regions(document(std::stod(why.substr(wall_at + 10)), radius));
            }
            if (ball_at != std::string::npos) {
              (void)regions(document(wall, std::stod(why.substr(ball_at + 19))));
            }
            ++refusals;
          }
        }
      }
    }
  }
  EXPECT_GE(bores, 30);
  EXPECT_EQ(bores + refusals, 36);
}

// The outer surface, and the crossing on it, change with a wall that is outside; where the two
// walls differ, it is said by how much of both.
TEST(Bore, of_tees_with_walls_outside_is_made_with_the_walls_that_are_said_to_do) {
  int walls = 0, shares = 0;
  for (const WallSide side : {WallSide::inwards, WallSide::centred, WallSide::outwards}) {
    for (const double of_branch : {1.0, 0.5}) {
      for (const double ball : {6.0, 9.0, 12.0}) {
        const double wall = 2;
        const auto document = [&](double share) {
          Assembly assembly = walled(
              {pipe("run", {-60, 0, 0}, {60, 0, 0}, 9), pipe("branch", {0, 0, 0}, {30, 0, 60}, 4),
               fillet("f", "run", "branch", ball)},
              wall * share);
          assembly.wall_side = side;
          assembly.parts[1].wall = of_branch * wall * share;
          return assembly;
        };
        SCOPED_TRACE(testing::Message() << int(side) << ' ' << of_branch << ' ' << ball);
        try {
          (void)regions(document(1));
        } catch (const Error& error) {
          const std::string why = error.what();
          const auto wall_at = why.find("a wall of "), share_at = why.find("or walls ");
          if (wall_at != std::string::npos) {
            EXPECT_EQ(of_branch, 1);
            EXPECT_NO_THROW((void)regions(document(std::stod(why.substr(wall_at + 10)) / wall)));
            ++walls;
          } else if (share_at != std::string::npos) {
            EXPECT_THAT(why, HasSubstr(" times as thick would do"));
            EXPECT_NO_THROW((void)regions(document(std::stod(why.substr(share_at + 9)))));
            ++shares;
          }
        }
      }
    }
  }
  EXPECT_GE(walls, 3);
  EXPECT_GE(shares, 3);
}

// The last cone narrows on its way to the hub, to less than the wall.
TEST(Bore, of_a_junction_is_refused_where_an_arm_is_thinner_than_the_wall) {
  JunctionOfPorts hub;
  hub.ends = {{"a", End::end}, {"b", End::end}, {"c", End::end}};
  const auto document = [&](double wall) {
    return walled({pipe("a", {-20, 0, 0}, {-16, 0, 0}, 1), pipe("b", {0, -20, 0}, {0, -16, 0}, 1),
                   part("c", ConeBetween{{19, 19, 0}, {14, 14, 0}, 2, 1.4}), part("hub", hub)},
                  wall, 0.02);
  };
  EXPECT_EQ(regions(document(0.1)).metal.solid.components(), 1);
  try {
    (void)regions(document(0.7));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
    EXPECT_EQ(error.part(), "hub");
    EXPECT_THAT(error.what(), HasSubstr("a wall of 0.7 leaves no bore where the radius is only"));
  }
}

// An end further back along its cone is thinner: what is told leaves walls their bores.
TEST(Bore, of_a_junction_is_thought_of_where_ends_are_told_to_move_back) {
  JunctionOfPorts hub;
  hub.ends = {{"a", End::end}, {"b", End::end}, {"c", End::end}};
  const auto told = [&](double wall) {
    try {
      (void)regions(
          walled({pipe("a", {-20, 0, 0}, {-1, 0, 0}, 1), pipe("b", {0, -20, 0}, {0, -1, 0}, 1),
                  part("c", ConeBetween{{9, 9, 0}, {1, 1, 0}, .1, 1}), part("hub", hub)},
                 wall, 0.02));
    } catch (const Error& error) {
      return error.message();
    }
    return std::string();
  };
  EXPECT_THAT(told(0.02), HasSubstr("centre: it would do to move back"));
  EXPECT_THAT(told(0.95), HasSubstr("centre: with its walls, no ends further back"));
}

// A piece is at fault, and the part that it is of is named, with its place.
TEST(Bore, of_a_chain_is_refused_where_a_piece_is_thinner_than_the_wall) {
  const auto document = [](double wall) {
    return walled(
        {part("chain", CyclideChainThrough{ChainFree(),
                                           {PeVector{{0, 0, 0}, 1}, PeVector{{3, 0, 0}, .65},
                                            PeVector{{6, 0, 0}, .3}},
                                           {}})},
        wall, 0.02);
  };
  EXPECT_EQ(regions(document(0.1)).metal.solid.components(), 1);
  try {
    (void)regions(document(0.5));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
    EXPECT_EQ(error.part(), "chain");
    EXPECT_EQ(error.where(), "/parts/0");
    EXPECT_EQ(error.message(),
              "piece 0: the wall of 0.5 is no thinner than the least sphere, of radius 0.3");
  }
}

// Offsets of cyclides are cyclides, and that of the hub is a sphere: volumes in closed form.
TEST(Bore, of_a_junction_is_the_junction_of_the_inner_radii) {
  const double wall = 0.4, tolerance = 0.004;
  JunctionOfPorts hub;
  hub.ends = {{"a", End::end}, {"b", End::end}, {"c", End::end}};
  const Assembly assembly =
      walled({pipe("a", {-20, 0, 0}, {-12, 0, 0}, 2), pipe("b", {20, 1, 0}, {12, 0.6, 0}, 1.5),
              pipe("c", {0, 15, 20}, {0, 9, 12}, 1.8), part("hub", hub)},
             wall, tolerance);
  const Regions made = regions(assembly);
  EXPECT_EQ(made.outer.solid.euler_number(), 2);
  EXPECT_EQ(made.metal.solid.euler_number(), -2);
  EXPECT_EQ(made.fluid.solid.euler_number(), 2);
  const ResolvedAssembly resolved = resolve(assembly);
  Junction inner = resolved.junctions.front().shape;
  const auto thinner = [&](const PeArc& arc) {
    const PeVector by{Vec3::Zero(), wall};
    return PeArc::from(arc.start() - by, arc.start_tangent(), arc.end() - by);
  };
  inner.hub.radius -= wall;
  for (JunctionArm& arm : inner.arms) {
    arm.collar = thinner(arm.collar);
    if (arm.straight) {
      arm.straight = thinner(*arm.straight);
    }
  }
  const double pipes = kPi * (1.6 * 1.6 * 8 + 1.1 * 1.1 * std::hypot(8, 0.4) + 1.4 * 1.4 * 10);
  EXPECT_NEAR(made.fluid.solid.volume(), volume(inner) + pipes,
              tolerance * made.fluid.solid.area());
}

TEST(Bore, of_cones_and_cyclides_that_meet_in_sloped_rings_is_one) {
  const Regions made =
      regions(walled({part("cone", ConeBetween{{0, 0, -8}, {0, 0, 0}, 1, 2}),
                      pipe("pipe", {12, 0, 14}, {20, 0, 14}, 1.5),
                      part("blend", CyclideBlendBetween{{"cone", End::end}, {"pipe", End::start}})},
                     0.3));
  EXPECT_EQ(made.fluid.solid.components(), 1);
  EXPECT_EQ(made.fluid.solid.euler_number(), 2);
  EXPECT_EQ(made.metal.solid.euler_number(), 0);
}

TEST(Bore, narrows_where_walls_differ) {
  const Regions made =
      regions(walled({pipe("thin", {0, 0, 0}, {4, 2, 6}, 2),
                      part("thick", PipeAlong{PortReference{"thin", End::end}, 9}, 0.75)},
                     0.25, 0.002));
  EXPECT_EQ(made.fluid.solid.components(), 1);
  EXPECT_EQ(made.fluid.solid.euler_number(), 2);
  EXPECT_NEAR(made.fluid.solid.volume(), kPi * (1.75 * 1.75 * std::sqrt(56.0) + 1.25 * 1.25 * 9),
              0.5);
}

TEST(Bore, passes_through_parts_without_a_wall_and_ends_at_solid_ones) {
  const auto line = [](bool is_solid) {
    return walled({pipe("a", {0, 0, 0}, {20, 0, 0}, 2),
                   part("disc", PipeBetween{{10, 0, 0}, {11, 0, 0}, 3},
                        is_solid ? std::nullopt : std::optional(0.0), is_solid)},
                  0.25);
  };
  const Regions through = regions(line(false)), plugged = regions(line(true));
  EXPECT_EQ(through.fluid.solid.components(), 1);
  EXPECT_EQ(plugged.fluid.solid.components(), 2);
  EXPECT_THAT(names(plugged.fluid.solid), IsSupersetOf({"disc.start", "disc.end"}));
  EXPECT_NEAR(through.fluid.solid.volume() - plugged.fluid.solid.volume(), kPi * 1.75 * 1.75, 0.2);
}

TEST(Bore, agrees_with_another_engine) {
  BuildOptions options;
  options.region = Region::metal;
  options.segments = 12;
  options.cross_check = CrossCheckEngine::nef;
  if (!has_cross_check()) {
    GTEST_SKIP() << "this build has no other engine";
  }
  const Built made = build(
      walled({pipe("run", {-8, 0, 0}, {8, 0, 0}, 3), pipe("branch", {0, 0, 0}, {0, 1, 9}, 2)}, 0.5),
      options);
  ASSERT_TRUE(made.cross_check);
  EXPECT_EQ(made.cross_check->verdict, CrossCheck::Verdict::agrees);
  EXPECT_EQ(made.cross_check->volume, made.solid.exact_volume());
}

TEST(Bore, of_hollow_chains_is_what_their_walls_enclose) {
  const auto arm = [](double own_wall, std::optional<double> said) {
    Assembly assembly{"", Unit::millimetre, 0.02, {}, {}};
    assembly.parts.push_back(
        part("arm",
             CyclideChainThrough{
                 ChainFree{}, {{{0, 0, 0}, 1}, {{4, 0, 1}, 1.2}, {{8, 1, 0}, 0.9}}, {}, own_wall},
             said));
    return assembly;
  };
  const Regions made = regions(arm(0.1, {}));
  EXPECT_EQ(made.metal.solid.exact_volume(),
            built(arm(0, 0.1), Region::metal).solid.exact_volume());
  EXPECT_EQ(made.metal.solid.euler_number(), 0);
  // Without a region it is what it was: rims along the normals.
  EXPECT_FALSE(built(arm(0.1, {}), {}).volumes);
}

TEST(Bore, keeps_out_of_a_part_that_its_end_faces) {
  for (const double gap : {0.05, 1e-2, 1e-5, 1e-7}) {
    for (const double far : {0.0, 238409.0}) {
      SCOPED_TRACE(std::to_string(gap) + " at " + std::to_string(far));
      const Vec3 at(far, far / 3, 0);
      const Regions made =
          regions(walled({pipe("a", at, at + Vec3(9, 0, 0), 1),
                          pipe("b", at + Vec3(9 + gap, 0, 0), at + Vec3(19, 0, 0), 1.6)},
                         0.5));
      EXPECT_EQ(made.metal.solid.components(), 2);
      EXPECT_EQ(made.metal.solid.euler_number(), 0);
      EXPECT_EQ(made.fluid.solid.euler_number(), 4);
    }
  }
}

TEST(Bore, that_ends_blind_is_said) {
  const auto nozzle = [](double from) {
    return walled({part("ball", SphereAt{{0, 0, 0}, 3}), pipe("a", {from, 0, 0}, {9, 0, 0}, 1)},
                  0.5);
  };
  const Built blind = built(nozzle(2.7), Region::fluid), open = built(nozzle(0), Region::fluid);
  EXPECT_EQ(blind.solid.components(), 2);
  EXPECT_THAT(
      blind.parts[1].warnings,
      testing::ElementsAre("its bore ends blind at its start, which lies inside of a wall"));
  EXPECT_THAT(names(blind.solid), testing::Contains("a.bore.start"));
  EXPECT_EQ(open.solid.components(), 1);
  EXPECT_THAT(open.parts[1].warnings, testing::IsEmpty());
}

// Both in one plane, in any direction, far away: the bore's end and the solid's crossed each other.
TEST(Bore, that_ends_at_a_solid_part_ends_in_one_face) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 20; ++round) {
    const Vec3 at(249986.7654, 114190.6789, 12392.2065);
    const Vec3 way =
        round == 0 ? Vec3(Vec3::UnitX())
                   : Vec3(Vec3(uniform(random), uniform(random), uniform(random)).normalized());
    const double length = round % 2 == 0 ? 30 : 0.01;
    const PortReference port{"a", End::end};
    const std::vector<Part> parts{pipe("a", at - 300 * way, at, 57.15),
                                  round % 3 == 0
                                      ? part("cap", FlangeOfEnd{port, 110, length}, {}, true)
                                      : part("cap", PipeAlong{port, length}, {}, true)};
    const Regions made = regions(walled(parts, 3, 0.1));
    EXPECT_EQ(made.metal.solid.euler_number(), 2) << round;
    EXPECT_EQ(names(made.fluid.solid), (std::set<std::string>{"a.bore", "a.start", "a.bore.end"}))
        << round;
  }
}

// A flange's face and the pipe's end lie in one plane, and so do the faces of two flanges.
TEST(Bore, opens_in_the_end_of_its_pipe_whole_where_there_are_flanges) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 12; ++round) {
    const Vec3 at(249986.7654, 114190.6789, 12392.2065);
    const Vec3 way = Vec3(uniform(random), uniform(random), uniform(random)).normalized();
    std::vector<Part> parts{pipe("a", at - 300 * way, at, 57.15),
                            part("f", FlangeOfEnd{PortReference{"a", End::end}, 110, 20})};
    const bool goes_on = round % 2 == 0;
    if (goes_on) {
      parts.push_back(part("b", PipeAlong{PortReference{"a", End::end}, 200}));
      parts.push_back(part("g", FlangeOfEnd{PortReference{"b", End::start}, 110, 20}));
    }
    const Regions made = regions(walled(parts, 3, 0.1));
    EXPECT_EQ(made.outer.solid.euler_number(), 2) << round;
    EXPECT_EQ(made.metal.solid.euler_number(), 0) << round;
    EXPECT_EQ(made.fluid.solid.euler_number(), 2) << round;
    EXPECT_EQ(names(made.fluid.solid),
              goes_on ? (std::set<std::string>{"a.bore", "a.start", "b.bore", "b.end"})
                      : (std::set<std::string>{"a.bore", "a.start", "a.end"}))
        << round;
    EXPECT_EQ(names(made.outer.solid).contains("f.end"), !goes_on) << round;
  }
}

// Of a branch as thick as the run, which begins on the run's axis, slivers lie in the run's wall.
TEST(Bore, that_begins_in_one_as_wide_is_open) {
  for (const double turn : {0.0, 0.3, 1.0}) {
    const Vec3 way(std::cos(turn) * 9, std::sin(turn) * 9, 0);
    const Built tee = built(
        walled({pipe("run", {0, 0, -9}, {0, 0, 9}, 1), pipe("branch", {0, 0, 0}, way, 1)}, 0.2),
        Region::fluid);
    EXPECT_EQ(tee.solid.components(), 1);
    EXPECT_THAT(tee.parts[1].warnings, testing::IsEmpty()) << turn;
  }
}

// At the end of the one or the start of the other: the next pipe was solid metal, without a word.
TEST(Bore, of_pipes_with_a_blind_flange_where_they_meet_is_in_both) {
  for (const PortReference& port : {PortReference{"p", End::end}, PortReference{"q", End::start}}) {
    const double between = 5;
    const Regions made = regions(walled(
        {pipe("p", {0, 0, 0}, {100, 0, 0}, 10), part("f", FlangeOfEnd{port, 20, between}, {}, true),
         part("q", PipeAlong{PortReference{"p", End::end}, 100})},
        1, 0.01));
    EXPECT_EQ(made.fluid.solid.components(), 2) << port.part;
    EXPECT_NEAR(made.fluid.solid.volume(), kPi * 81 * (200 - between), 100) << port.part;
  }
}

// No finer mesh helps.
TEST(Bore, that_ends_in_an_end_called_as_its_part_says_so) {
  Assembly closed = walled({pipe("a", {0, 0, 0}, {9, 0, 0}, 2)}, 0.5);
  closed.patches = {{"a.start", "a"}};
  try {
    (void)built(closed, Region::metal);
    ADD_FAILURE() << "was built";
  } catch (const Error& error) {
    EXPECT_THAT(error.message(), HasSubstr("the patch 'a.start' is called 'a' as its part is"));
  }
  closed.patches = {{"a.start", "b"}};
  EXPECT_EQ(built(closed, Region::metal).solid.euler_number(), 0);
}

// The balls are not concentric then; finer meshes were said to do.
TEST(Bore, of_a_fillet_breaks_through_where_walls_differ) {
  Assembly slanted =
      walled({pipe("run", {-200, 0, 0}, {200, 0, 0}, 30),
              pipe("branch", {0, 0, 0}, {100, 0, 100}, 15), fillet("fillet", "run", "branch", 5)},
             4, 0.1);
  slanted.parts[1].wall = 1;
  std::string said;
  try {
    (void)built(slanted, Region::metal);
    ADD_FAILURE() << "was built";
  } catch (const Error& error) {
    said = error.message();
  }
  EXPECT_THAT(said, HasSubstr("the fillet breaks through the outer one, as the walls differ; a "
                              "wall of "));
  EXPECT_THAT(said, HasSubstr(" of 'branch' would do"));
  slanted.parts[1].wall = std::stod(said.substr(said.find("a wall of ") + 10));
  EXPECT_GT(built(slanted, Region::metal).solid.volume(), 0);
}

void expect_ball_refused(double wall, Errc code, const std::string& said) {
  try {
    (void)built(walled({part("ball", SphereAt{{0, 0, 0}, 3})}, wall), Region::metal);
    ADD_FAILURE() << "was built";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    EXPECT_THAT(error.message(), HasSubstr(said));
  }
}

TEST(Bore, of_a_thin_wall_that_asks_for_too_much_says_so) {
  expect_ball_refused(1e-7, Errc::limit_exceeded,
                      "here it is a quarter of the thinnest wall, which is 1e-07");
}

TEST(Bore, of_a_wall_too_thin_for_the_coordinates_says_so) {
  expect_ball_refused(1e-12, Errc::invalid_argument, "the thinnest wall, which is 1e-12");
}

TEST(Bore, of_random_bent_lines_and_their_branches_sums_up) {
  std::mt19937_64 random(20261124);
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  for (int round = 0; round < 12; ++round) {
    SCOPED_TRACE(round);
    const double radius = uniform(0.5, 2), wall = radius * uniform(0.05, 0.4);
    const Vec3 far(uniform(8, 20), uniform(-9, 9), uniform(-9, 9));
    const Vec3 along = (far + Vec3(0, uniform(-4, 4), uniform(-4, 4))).normalized();
    std::vector<Part> parts{
        pipe("a", {-12, 0, 0}, {0, 0, 0}, radius),
        pipe("b", far, far + 12 * along, radius * uniform(0.6, 1.4) + wall),
        part("blend", CyclicBlendBetween{{"a", End::end}, {"b", End::start}, {}}),
        pipe("branch", {-6, 0, 0}, {-6, uniform(-1, 1), 4 * radius + 3},
             wall + uniform(0.2, 0.5) * radius)};
    const Regions made = regions(walled(parts, wall, 0.02));
    EXPECT_EQ(made.metal.solid.components(), 1);
    EXPECT_EQ(made.fluid.solid.components(), 1);
  }
}

struct Refused {
  std::string name;
  Assembly assembly;
  Errc code;
  std::string place, reason;
};

TEST(Bore, that_there_is_not_is_refused_with_the_reason) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Part> one{pipe("a", {0, 0, 0}, {9, 0, 0}, 2)};
  Assembly no_wall = walled(one, 1);
  no_wall.wall.reset();
  std::vector<Refused> rows{
      {"too thick", walled(one, 2), Errc::infeasible_blend, "/parts/0",
       "a wall of 2 leaves no bore where the radius is only 2"},
      {"not a number", walled(one, nan), Errc::invalid_argument, "/wall",
       "positive number between 1e-12 and 1e12, not nan"},
      {"negative", walled(one, -1), Errc::invalid_argument, "/wall",
       "positive number between 1e-12 and 1e12, not -1"},
      {"none", no_wall, Errc::invalid_argument, "/wall",
       "neither the document nor a part says how thick a wall is"},
      {"of a part", walled({part("a", PipeBetween{{0, 0, 0}, {9, 0, 0}, 2}, nan)}, 1),
       Errc::invalid_argument, "/parts/0/wall", "0 for none, or between 1e-12 and 1e12, not nan"},
      {"of a cap", walled({one[0], part("c", CapAt{{"a", End::end}}, 1.0)}, 1),
       Errc::invalid_argument, "/parts/1/wall", "a cap has the wall of the parts it is at"},
      {"solid with wall", walled({part("a", one[0].shape, 1.0, true)}, 1), Errc::invalid_argument,
       "/parts/0/wall", "a solid part has no wall"},
      {"broken", walled({one[0], pipe("b", {4, 0, 1.2}, {4, 0, 9}, 1.95)}, 0.1),
       Errc::infeasible_blend, "/parts/0",
       ": there is no wall where an open end of 'b' is cut; that end must be elsewhere, or 'b' "
       "without a bore (\"wall\": 0)"},
  };
  rows.back().assembly.parts[1] = pipe("b", {8.5, 0, 0}, {20, 0, 0}, 3);
  const Assembly broken = rows.back().assembly;
  // It comes back over the open end of its neighbour.
  rows.push_back(
      {"broken by a neighbour",
       walled(
           {pipe("a", {-40, 0, 0}, {0, 0, 0}, 19),
            part("b",
                 ElbowTurning{
                     PortReference{"a", End::end}, 54, 327 * std::numbers::pi / 180, {0, 1, 0}})},
           4),
       Errc::infeasible_blend, "/parts/1", ": there is no wall where an open end of 'a' is cut"});
  for (const Refused& row : rows) {
    SCOPED_TRACE(row.name);
    try {
      (void)built(row.assembly, Region::fluid);
      ADD_FAILURE() << "was built";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), row.code);
      EXPECT_THAT(error.where(), HasSubstr(row.place));
      EXPECT_THAT(error.message(), HasSubstr(row.reason));
    }
  }
  Assembly elsewhere = broken, without_bore = broken;
  elsewhere.parts[1] = pipe("b", {9.5, 0, 0}, {20, 0, 0}, 3);
  without_bore.parts[1].wall = 0;
  EXPECT_FALSE(built(elsewhere, Region::fluid).solid.empty());
  EXPECT_FALSE(built(without_bore, Region::fluid).solid.empty());
}

TEST(Walls, are_of_parts_before_they_are_of_the_document) {
  Assembly assembly = walled(
      {pipe("a", {0, 0, 0}, {9, 0, 0}, 2), part("b", PipeBetween{{20, 0, 0}, {30, 0, 0}, 2}, 0.5),
       part("c", PipeBetween{{40, 0, 0}, {50, 0, 0}, 2}, {}, true)},
      1);
  const ResolvedAssembly resolved = resolve(assembly);
  EXPECT_EQ(walls_of(assembly, resolved, {}), (std::vector<double>{1, 0.5, 0}));
  assembly.wall.reset();
  EXPECT_EQ(walls_of(assembly, resolved, {}), (std::vector<double>{0, 0.5, 0}));
  assembly.parts[1].wall = 0;
  EXPECT_EQ(walls_of(assembly, resolved, Region::metal), std::nullopt);
}

}  // namespace
}  // namespace dupin::assembly
