#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blends/network/piping_network_internal.h"
#include "dupin/blends/build.h"
#include "dupin/kernel/error.h"
#include "network/piping_fillets.h"

namespace dupin::network {
namespace {

using testing::HasSubstr;

PipingComponent pipe(const Vec3& from, const Vec3& to, double radius = 50) {
  return component(PipingShape::straight, {from, to}, {}, radius);
}

// A tee whose body reaches so far from its centre, between long pipes.
PipingLine tee(double reach, double radius = 30) {
  auto body = component(PipingShape::fitting, {{-reach, 0, 0}, {reach, 0, 0}, {0, 0, reach}},
                        Vec3(0, 0, 0));
  body.ports[2].radius = radius;
  return line_of({body, pipe({reach, 0, 0}, {500, 0, 0}), pipe({-500, 0, 0}, {-reach, 0, 0}),
                  pipe({0, 0, reach}, {0, 0, 400}, radius)});
}

std::string notes(const PipingNetwork& network) {
  std::string text;
  for (const SourceNote& note : network.notes) {
    text += note.text + "\n";
  }
  return text;
}

double ball(const PipingNetwork& network) {
  for (const Part& part : network.assembly.parts) {
    if (const auto* fillet = std::get_if<FilletBetween>(&part.shape)) {
      return fillet->radius;
    }
  }
  return 0;
}

TEST(PipingFillets, are_as_asked_or_chosen) {
  EXPECT_EQ(ball(assembly_of(tee(100), {.fillet = 9})), 9);
  EXPECT_EQ(ball(assembly_of(tee(100), {.fillet = 0})), 7.5);
  EXPECT_EQ(ball(assembly_of(tee(100), {})), 0);
  EXPECT_THAT(notes(assembly_of(tee(100), {.fillet = 9})),
              HasSubstr("c0: c0-branch-fillet has a ball of radius 9"));
}

TEST(PipingFillets, take_room_from_pipes_beside_short_bodies) {
  const PipingNetwork network = assembly_of(tee(20), {.fillet = 9});
  EXPECT_EQ(ball(network), 9);
  const Built built = build(network.assembly, {.tolerance = .5});
  EXPECT_EQ(built.solid.components(), 1);
  EXPECT_EQ(built.solid.euler_number(), 2);
  EXPECT_EQ(network.largest_move, 0);
}

TEST(PipingFillets, fit_equal_tees) {
  const PipingNetwork network = assembly_of(tee(100, 50), {.fillet = 9});
  EXPECT_EQ(build(network.assembly, {.tolerance = .5}).solid.euler_number(), 2);
}

// As most crosses are.
TEST(PipingFillets, fit_equal_crosses) {
  const auto body = component(PipingShape::fitting,
                              {{-90, 0, 0}, {90, 0, 0}, {0, 0, 90}, {0, 0, -90}}, Vec3(0, 0, 0));
  const PipingLine cross =
      line_of({body, pipe({90, 0, 0}, {500, 0, 0}), pipe({-500, 0, 0}, {-90, 0, 0}),
               pipe({0, 0, 90}, {0, 0, 400}), pipe({0, 0, -400}, {0, 0, -90})});
  const PipingNetwork network = assembly_of(cross, {.fillet = 9});
  EXPECT_EQ(ball(network), 9);
  const Built built = build(network.assembly, {.tolerance = .5});
  EXPECT_EQ(built.solid.components(), 1);
  EXPECT_EQ(built.solid.euler_number(), 2);
}

TEST(PipingFillets, that_do_not_fit_are_refused_or_if_chosen_noted) {
  PipingLine line = tee(100);
  line.components.resize(1);  // nothing beside it
  try {
    (void)assembly_of(line, {.fillet = 60});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.part(), "c0");
    EXPECT_THAT(error.what(), HasSubstr("c0-branch-fillet does not fit: "));
    EXPECT_THAT(error.what(), HasSubstr("the largest ball that fits, to 1 %, has a radius of"));
  }
  const PipingNetwork going_on = assembly_of(line, {.fillet = 60, .keep_going = true});
  EXPECT_EQ(ball(going_on), 0);
  EXPECT_TRUE(going_on.notes.at(0).is_refusal);
  PipingLine tight = tee(51, 50);
  tight.components.resize(1);
  const PipingNetwork chosen = assembly_of(tight, {.fillet = 0});
  EXPECT_EQ(ball(chosen), 0);
  EXPECT_THAT(notes(chosen), HasSubstr("c0: has no fillet: "));
  EXPECT_FALSE(chosen.notes.at(0).is_refusal);
}

TEST(PipingFillets, keep_walls) {
  const PipingNetwork network = assembly_of(tee(100), {.wall = 4, .fillet = 9});
  const Built fluid = build(network.assembly, {.tolerance = .5, .region = Region::fluid});
  EXPECT_EQ(fluid.solid.components(), 1);
  EXPECT_EQ(fluid.solid.euler_number(), 2);
}

}  // namespace
}  // namespace dupin::network
