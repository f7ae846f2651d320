#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
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
