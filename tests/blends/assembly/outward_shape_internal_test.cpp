#include <gtest/gtest.h>

#include "assembly/outward_shape.h"
#include "blends/assembly/hollow_regions.h"
#include "dupin/kernel/error.h"
#include "support/named_parts.h"

namespace dupin::assembly {
namespace {

using test::built;
using test::pipe;
using test::Regions;
using test::regions;

Assembly walled(std::vector<Part> parts, double wall, WallSide side) {
  Assembly assembly{"", Unit::millimetre, 0.02, {}, std::move(parts), wall};
  assembly.wall_side = side;
  return assembly;
}

std::vector<Part> line(double radius) {
  return {pipe("a", {0, 0, 0}, {20, 0, 0}, radius),
          {"bend", ElbowTurning{PortReference{"a", End::end}, 12, 1.5, {0, 1, 0}}},
          {"cone", ConeAlong{PortReference{"bend", End::end}, 10, radius / 2, {}, {}}},
          pipe("branch", {10, 0, 0}, {10, 0, 20}, radius / 2)};
}

// The same solid, said by its inside radii, by those in the middle, and by those outside.
TEST(OutwardShape, makes_one_solid_of_radii_on_either_side) {
  const double wall = 0.5;
  const Regions inwards = regions(walled(line(4), wall, WallSide::inwards));
  std::vector<Part> inside = line(3.5), middle = line(3.75);
  std::get<ConeAlong>(inside[2].shape).end_radius = 1.5;
  std::get<ConeAlong>(middle[2].shape).end_radius = 1.75;
  std::get<PipeBetween>(inside[3].shape).radius = 1.5;
  std::get<PipeBetween>(middle[3].shape).radius = 1.75;
  EXPECT_EQ(regions(walled(inside, wall, WallSide::outwards)).metal.solid.exact_volume(),
            inwards.metal.solid.exact_volume());
  EXPECT_EQ(regions(walled(middle, wall, WallSide::centred)).fluid.solid.exact_volume(),
            inwards.fluid.solid.exact_volume());
}

TEST(OutwardShape, grows_radii_and_nothing_else) {
  const auto pipe = std::get<PipeBetween>(
      outward_shape(PipeBetween{{0, 0, 0}, {1, 0, 0}, 2, SectionAxes{Vec3::UnitZ(), 1}}, 0.5));
  EXPECT_EQ(pipe.radius, 2.5);
  EXPECT_EQ(pipe.axes->across, 1.5);
  EXPECT_EQ(pipe.to, Vec3(1, 0, 0));
  const auto head = std::get<TorisphericalHead>(
      outward_shape(TorisphericalHead{PortReference{"a", End::end}, HeadForm::free, 4, 0.5}, 0.25));
  EXPECT_EQ(head.crown, 4.25);
  EXPECT_EQ(head.knuckle, 0.75);
  EXPECT_EQ(std::get<FilletBetween>(outward_shape(FilletBetween{{"a", "b"}, 3}, 1)).radius, 3);
}

TEST(OutwardShape, of_neighbours_with_different_walls_is_refused) {
  std::vector<Part> parts = line(4);
  parts[1].wall = 0.25;
  try {
    (void)built(walled(parts, 0.5, WallSide::outwards), Region::metal);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.part(), "bend");
    EXPECT_EQ(error.message(),
              "it shares a ring with 'a', whose outer surface is 0.5 outside of the radii in the "
              "document, and its own 0.25; where radii are not outside ones, neighbours have the "
              "same wall and wall_side");
  }
  EXPECT_NO_THROW((void)built(walled(parts, 0.5, WallSide::inwards), Region::metal));
}

}  // namespace
}  // namespace dupin::assembly
