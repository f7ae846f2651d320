#include <numbers>
#include <random>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/bore.h"
#include "blends/assembly/hollow_regions.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/error.h"
#include "support/named_parts.h"

namespace dupin::assembly {
namespace {

using test::built;
using test::fillet;
using test::pipe;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

Assembly insulated(std::vector<Part> parts, double thickness) {
  Assembly assembly{"", Unit::millimetre, 0.01, {}, std::move(parts)};
  assembly.insulation = thickness;
  return assembly;
}

// Of the same assembly.
void expect_around(const Assembly& assembly, const Solid& insulation) {
  EXPECT_TRUE(check(to_mesh(insulation).mesh()).is_solid());
  const Solid outer = built(assembly, Region::outer).solid;
  EXPECT_TRUE(intersect(std::array{outer, insulation}).empty());
}

TEST(Insulation, of_a_pipe_is_a_tube_around_it) {
  const Assembly assembly = insulated({pipe("a", {0, 0, 0}, {10, 0, 0}, 1)}, 0.5);
  const Built made = built(assembly, Region::insulation);
  EXPECT_NEAR(*made.insulation, kPi * (1.5 * 1.5 - 1) * 10, 0.5);
  EXPECT_EQ(made.solid.euler_number(), 0);
  EXPECT_EQ(made.region, Region::insulation);
  EXPECT_FALSE(made.volumes) << "there is no wall";
  expect_around(assembly, made.solid);
}

TEST(Insulation, goes_round_bends_balls_and_fillets) {
  std::vector<Part> parts = {
      pipe("run", {-20, 0, 0}, {20, 0, 0}, 3),
      pipe("branch", {0, 0, 0}, {0, 0, 15}, 2),
      fillet("throat", "run", "branch", 1),
      {"bend", ElbowTurning{PortReference{"run", End::end}, 6, 1.5, {0, 1, 0}}},
      {"ball", SphereAt{{-20, 0, 0}, 4}},
      {"head", EllipsoidalHead{PortReference{"branch", End::end}}}};
  // Thinner than the fillet's ball, and thicker, where the edge is sharp.
  for (const double thickness : {0.5, 1.5}) {
    const Assembly assembly = insulated(parts, thickness);
    const Built made = built(assembly, Region::insulation);
    EXPECT_EQ(made.solid.components(), 1);
    expect_around(assembly, made.solid);
  }
}

// Its ends lie in the planes of the pipe's and of the flange's, in any direction, far away. Films
// were left of it between them, each end being rounded by itself.
TEST(Insulation, ends_in_one_face_each) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 12; ++round) {
    const Vec3 at(249986.7654, 114190.6789, 12392.2065);
    const Vec3 way = Vec3(uniform(random), uniform(random), uniform(random)).normalized();
    Assembly assembly = insulated({pipe("a", at, at + 300 * way, 57.15),
                                   {"f", FlangeOfEnd{PortReference{"a", End::end}, 110, 20}}},
                                  30);
    assembly.tolerance = 0.1;
    assembly.parts[1].insulation = 0;
    const Built made = built(assembly, Region::insulation);
    EXPECT_EQ(made.solid.components(), 1) << round;
    EXPECT_EQ(made.solid.euler_number(), 0) << round;
    std::set<std::string> names;
    for (const std::uint32_t label : made.solid.labels()) {
      names.insert(made.solid.names()[label]);
    }
    EXPECT_EQ(names, (std::set<std::string>{"a", "a.insulation", "a.insulation.start", "f.start"}))
        << round;
    EXPECT_NEAR(*made.insulation, kPi * (87.15 * 87.15 - 57.15 * 57.15) * 280, 0.1 * 2e5);
  }
}

TEST(Insulation, is_of_the_parts_that_have_it) {
  Assembly assembly = insulated({pipe("a", {0, 0, 0}, {10, 0, 0}, 1),
                                 {"b", PipeAlong{PortReference{"a", End::end}, 10}, {}, false}},
                                0.5);
  assembly.parts[0].insulation = 0;
  assembly.wall = 0.1;
  const Built made = built(assembly, Region::insulation);
  EXPECT_NEAR(*made.insulation, kPi * (1.5 * 1.5 - 1) * 10, 0.5);
  assembly.parts[1].insulation = 0;
  EXPECT_THROW((void)built(assembly, Region::insulation), Error);
}

TEST(Insulation, that_a_bend_cannot_follow_is_refused_by_its_name) {
  const Assembly assembly =
      insulated({pipe("a", {0, 0, 0}, {10, 0, 0}, 1),
                 {"bend", ElbowTurning{PortReference{"a", End::end}, 1.5, 1.5, {0, 1, 0}}}},
                0.75);
  try {
    (void)built(assembly, Region::insulation);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.part(), "bend");
    EXPECT_EQ(error.code(), Errc::irregular_surface);
    EXPECT_THAT(
        error.message(),
        HasSubstr("its insulation of 0.75 is too thick for its bends; it may be at most 0.499999"));
  }
}

// Within the digits that are said, on both sides.
TEST(Insulation, that_is_too_thick_is_refused_with_the_largest_that_is_not) {
  const auto bent = [](double thickness) {
    return insulated({pipe("a", {0, 0, -20}, {0, 0, 0}, 5),
                      {"bend", ElbowTurning{PortReference{"a", End::end}, 15, 1.5, {1, 0, 0}}}},
                     thickness);
  };
  const std::string remedy = "it may be at most ";
  try {
    (void)built(bent(12), Region::insulation);
    ADD_FAILURE();
  } catch (const Error& error) {
    const std::size_t at = error.message().find(remedy);
    ASSERT_NE(at, std::string::npos) << error.message();
    const double most = std::stod(error.message().substr(at + remedy.size()));
    EXPECT_NO_THROW((void)built(bent(most), Region::insulation));
    EXPECT_THROW((void)built(bent(most + 1e-5), Region::insulation), Error);
  }
}

TEST(Insulation, that_a_cyclide_cannot_follow_is_refused_with_what_would_do) {
  const auto bent = [](double thickness) {
    return insulated(
        {pipe("a", {-20, 0, 0}, {-10, 0, 0}, 1),
         pipe("b", {0, 10, 0}, {0, 20, 0}, 1),
         {"s", CyclideBlendBetween{PortReference{"a", End::end}, PortReference{"b", End::start}}}},
        thickness);
  };
  std::string message;
  try {
    (void)built(bent(20), Region::insulation);
  } catch (const Error& error) {
    EXPECT_EQ(error.part(), "s");
    message = error.message();
  }
  const std::string remedy = "its insulation of 20 is too thick for its bends; it may be at most ";
  ASSERT_TRUE(message.starts_with(remedy)) << message;
  const double most = std::stod(message.substr(remedy.size()));
  EXPECT_NEAR(most, 9, 0.001);
  EXPECT_NO_THROW((void)built(bent(most), Region::insulation));
  EXPECT_THROW((void)built(bent(1.00001 * most), Region::insulation), Error);
}

TEST(Insulation, of_a_junction_is_refused_where_it_is_too_thick_for_its_collars) {
  JunctionOfPorts hub;
  hub.ends = {{"a", End::end}, {"b", End::end}};
  const auto document = [&](double thickness) {
    return insulated(
        {pipe("a", {29, 0, 0}, {9, 0, 0}, 1), pipe("b", {0, 29, 0}, {0, 9, 0}, 1.5), {"hub", hub}},
        thickness);
  };
  const std::string remedy = "its insulation of 1 is too thick for its bends; ";
  try {
    (void)built(document(1), Region::insulation);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.part(), "hub");
    ASSERT_TRUE(error.message().starts_with(remedy)) << error.message();
    EXPECT_TRUE(error.message().ends_with(" would do")) << error.message();
    const double most = std::stod(error.message().substr(remedy.size()));
    EXPECT_EQ(built(document(most), Region::insulation).solid.components(), 1);
  }
}

}  // namespace
}  // namespace dupin::assembly
