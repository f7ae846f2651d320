#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"
#include "support/pipe_unions.h"
#include "support/plants.h"

/// Plants whose components miss each other by 1e-5 to 0.5 mm, where binary32 has a spacing of 0.03
/// to 0.25 mm. DUPIN_LARGE_CASES asks for more of them.
namespace dupin {
namespace {

#ifdef DUPIN_LARGE_CASES
constexpr std::uint32_t kPlants = 24;
constexpr std::size_t kComponents = 200;
#else
constexpr std::uint32_t kPlants = 6;
constexpr std::size_t kComponents = 20;
#endif

class PlantsBySeed : public testing::TestWithParam<std::uint32_t> {};

TEST_P(PlantsBySeed, are_written_as_floats_where_they_stand) {
  std::vector<Solid> components;
  for (const TriMesh& mesh : test::plant({.seed = GetParam(), .components = kComponents})) {
    components.push_back(Solid::from(mesh));
  }
  const Solid plant = unite(components);
  for (const Coordinates coordinates : {Coordinates::binary64, Coordinates::binary32}) {
    const Rounded rounded = to_mesh(plant, coordinates);
    const Report report = check(rounded.mesh());
    EXPECT_TRUE(report.is_solid());
    EXPECT_EQ(rounded.mesh().triangles.size(), rounded.sources().size());
    // What is filled and moved is no more than ends miss each other by, at flanges out of line.
    EXPECT_LE(rounded.report().slit_width, 16);
    EXPECT_LE(rounded.report().largest_move, 32);
    EXPECT_NEAR(Solid::from(rounded.mesh()).volume() / plant.volume(), 1, 4e-3);
  }
}

Solid large_plant(std::uint32_t seed) {
  std::vector<Solid> components;
  for (const TriMesh& mesh : test::plant({.seed = seed, .components = 600})) {
    components.push_back(Solid::from(mesh));
  }
  return unite(components);
}

// A sliver of eight triangles came to lie, whole, on the other side of what it touches.
TEST(Plants, keep_slivers_on_their_sides) {
  EXPECT_TRUE(check(to_mesh(large_plant(3037), Coordinates::binary32).mesh()).is_solid());
}

// Two triangles that crossed were cut, and rounded to what they had been, again and again.
TEST(Plants, come_to_an_end_where_cutting_changes_nothing) {
  const Rounded rounded = to_mesh(large_plant(5125), Coordinates::binary32);
  EXPECT_TRUE(check(rounded.mesh()).is_solid());
  EXPECT_LE(rounded.report().snapped_places.size(), 8);
}

// What is between such pipes is no slit between ends: it is not filled, all along the pipes, which
// took hundreds of times the union, and moved them by half their radius.
TEST(Racks, whose_pipes_rest_on_others_keep_their_shape) {
  for (std::uint32_t seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE(seed);
    const Solid rack = unite(test::resting_pipes(20, seed, 140));
    const Rounded rounded = to_mesh(rack, Coordinates::binary32);
    EXPECT_TRUE(check(rounded.mesh()).is_solid());
    EXPECT_TRUE(rounded.report().filled_places.empty());
    EXPECT_LE(rounded.report().largest_move, 5);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, PlantsBySeed, testing::Range(std::uint32_t{0}, kPlants));

}  // namespace
}  // namespace dupin
