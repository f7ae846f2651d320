#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/rounding.h"
#include "support/pipe_unions.h"
#include "support/shapes.h"

namespace dupin {
namespace {

TEST(RoundingApart, separates_by_a_spacing_or_a_few) {
  const std::vector<Solid> boxes = {Solid::from(test::box({0, 0, 0}, {1, 1, 1})),
                                    Solid::from(test::box({1, 1, 0}, {2, 2, 1}))};
  for (const Coordinates coordinates : {Coordinates::binary32, Coordinates::binary64}) {
    const RoundedApart apart = rounded_apart(unite(boxes), coordinates);
    EXPECT_TRUE(apart.rounded.contacts().empty());
    EXPECT_TRUE(check(apart.rounded.mesh()).is_solid());
    ASSERT_EQ(apart.contacts.size(), 1);
    EXPECT_EQ(apart.contacts.front().kind, Contact::Kind::edge);
    EXPECT_GT(apart.length, 0);
    EXPECT_LE(apart.length, coordinates == Coordinates::binary32 ? 0x1p-16 : 0x1p-24);
  }
}

/// Two cubes along one edge, at `place`, which has room for their coordinates.
Solid cubes_at(const Vec3& place, double size) {
  const auto cube = [&](const Vec3& from) {
    return Solid::from(test::box(place + from, place + from + Vec3::Constant(size)));
  };
  const std::vector<Solid> cubes = {cube({0, 0, 0}), cube({size, size, 0})};
  return unite(cubes);
}

double volume_of(const Rounded& rounded) { return Solid::from(rounded.mesh()).volume(); }

TEST(RoundingApart, takes_away_what_the_numbers_from_the_origin_cannot_tell) {
  for (const double size : {1.0, 0x1p-10}) {
    const Solid solid = cubes_at({0x1p20, 0x1p20, 0x1p20}, size);
    const Vec3 middle = Vec3::Constant(0x1p20 + size);
    for (const Origin& origin : {Origin{.choice = Origin::Choice::automatic},
                                 Origin{.choice = Origin::Choice::given, .place = middle}}) {
      const RoundedApart apart =
          rounded_apart(solid, Coordinates::binary32, {.origin = origin, .whole = {}});
      EXPECT_TRUE(apart.rounded.contacts().empty());
      EXPECT_LE(apart.length, 0x1p-21 * size);
      EXPECT_NEAR(volume_of(apart.rounded), solid.volume(), 0x1p-18 * solid.volume());
      ASSERT_EQ(apart.contacts.size(), 1);
      EXPECT_EQ(apart.contacts.front().from, solid.contacts().front().from) << "where it was given";
    }
  }
}

TEST(RoundingApart, begins_with_the_spacing_of_the_numbers_that_are_written) {
  const Solid solid = cubes_at({0, 0, 0}, 1);
  const Origin far{.choice = Origin::Choice::given, .place = {0x1p20, 0x1p20, 0}};
  const Whole whole{.box = {Vec3(0, 0, 0), Vec3(0x1p20, 2, 2)}};
  const RoundingOptions cases[] = {{.origin = far, .whole = {}},
                                   {.output_grid = 0x1p-4, .origin = {}, .whole = {}},
                                   {.origin = {}, .whole = whole}};
  for (const RoundingOptions& options : cases) {
    const RoundedApart apart = rounded_apart(solid, Coordinates::binary32, options);
    EXPECT_TRUE(apart.rounded.contacts().empty());
    EXPECT_GE(apart.length, 0x1p-4) << "what is told is what points are moved by";
    EXPECT_LE(apart.length, 0x1p-1);
    EXPECT_NEAR(volume_of(apart.rounded), 2, 0.5);
  }
}

// Seen from zero, its numbers cannot tell what is left from nothing.
TEST(RoundingApart, leaves_something) {
  const Solid solid = cubes_at({0x1p20, 0x1p20, 0x1p20}, 0x1p-10);
  try {
    EXPECT_FALSE(rounded_apart(solid, Coordinates::binary32).rounded.mesh().triangles.empty());
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::unroundable);
  }
}

TEST(RoundingApart, parts_what_touches_itself_once_it_is_rounded) {
  std::size_t parted = 0;
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const Solid solid = unite(test::resting_pipes(8, seed));
    const std::size_t contacts = to_mesh(solid, Coordinates::binary32).contacts().size();
    const RoundedApart apart = rounded_apart(solid, Coordinates::binary32);
    EXPECT_TRUE(apart.rounded.contacts().empty());
    EXPECT_GE(apart.contacts.size(), contacts);
    EXPECT_EQ(apart.length > 0, contacts > 0);
    parted += contacts > 0 ? 1 : 0;
  }
  EXPECT_GT(parted, 0);
}

TEST(RoundingApart, leaves_what_touches_nothing) {
  const Solid solid = Solid::from(test::box({0, 0, 0}, {1, 1, 1}));
  const RoundedApart apart = rounded_apart(solid, Coordinates::binary32);
  EXPECT_TRUE(apart.contacts.empty());
  EXPECT_EQ(apart.length, 0);
  EXPECT_EQ(apart.rounded.mesh().triangles.size(), 12);
}

}  // namespace
}  // namespace dupin
