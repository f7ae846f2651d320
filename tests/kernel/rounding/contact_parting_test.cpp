
#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"
#include "kernel/wedges.h"
#include "support/pipe_unions.h"
#include "support/plants.h"
#include "support/shapes.h"

namespace dupin {
namespace {

Rounded rounded(const Solid& solid) { return to_mesh(solid, Coordinates::binary32); }

bool has_all_points_apart(const TriMesh& mesh) {
  std::set<std::tuple<double, double, double>> places;
  for (const Vec3& p : mesh.points) {
    places.insert({p.x(), p.y(), p.z()});
  }
  return places.size() == mesh.points.size();
}

void expect_parted(const Rounded& result, const Rounded& touching) {
  EXPECT_TRUE(result.contacts().empty());
  EXPECT_TRUE(has_all_points_apart(result.mesh()));
  EXPECT_TRUE(check(result.mesh()).is_solid());
  EXPECT_EQ(result.sources().size(), result.mesh().triangles.size());
  const double volume = Solid::from(touching.mesh()).volume();
  EXPECT_NEAR(Solid::from(result.mesh()).volume(), volume, 1e-4 * volume);
  EXPECT_LE(result.report().parted_by, result.report().largest_move);
}

TEST(ContactParting, moves_apart_what_touches_along_an_edge_or_in_a_point) {
  for (const double z : {0.0, 2.0}) {
    const std::vector<Solid> boxes = {Solid::from(test::box({0, 0, 0}, {2, 2, 2})),
                                      Solid::from(test::box({2, 2, z}, {4, 4, z + 2}))};
    const Solid touching = unite(boxes);
    ASSERT_EQ(touching.contacts().size(), 1U);
    const Rounded before = rounded(touching), apart = parted(before);
    EXPECT_EQ(before.contacts().size(), 1U);
    expect_parted(apart, before);
    EXPECT_EQ(apart.report().parted.size(), 1U);
    EXPECT_GT(apart.report().parted_by, 0);
    EXPECT_LT(apart.report().parted_by, 1e-5);
  }
}

// A sliver, thinner than a spacing, whose tip touches a box: moved to the next number, the tip
// comes out at the sliver's other side, so that nothing is left of it.
TEST(ContactParting, drops_slivers_that_it_turns_inside_out) {
  const auto at = [](int x, int y, int z) { return Vec3(1.5e6 + Vec3(x, y, z).array() / 8); };
  const TriMesh sliver{{at(0, 0, 0), at(-1, -40, -30), at(0, 40, -30), at(-1, 0, 50)},
                       {{1, 2, 0}, {2, 3, 0}, {3, 1, 0}, {2, 1, 3}}};
  const std::vector<Solid> solids = {Solid::from(sliver),
                                     Solid::from(test::box(at(0, 0, 0), at(400, 400, 400)))};
  const Rounded before = rounded(unite(solids));
  ASSERT_EQ(before.contacts().size(), 1U);
  const Rounded apart = parted(before);
  expect_parted(apart, before);
  EXPECT_EQ(check(apart.mesh()).components, 1);
  EXPECT_EQ(apart.report().parted.size(), 1U);
}

// The tolerance is less than any move to a neighbouring number.
TEST(ContactParting, leaves_as_it_is_what_the_tolerance_forbids) {
  const std::vector<Solid> boxes = {Solid::from(test::box({0, 0, 0}, {2, 2, 2})),
                                    Solid::from(test::box({2, 2, 0}, {4, 4, 2}))};
  const Rounded result = parted(rounded(unite(boxes)), {.tolerance = 1e-12});
  EXPECT_EQ(result.contacts().size(), 1U);
  EXPECT_TRUE(result.report().parted.empty());
  EXPECT_EQ(result.report().largest_move, 0);
}

TEST(ContactParting, parts_racks_that_touch_themselves_once_they_are_rounded) {
  std::size_t touching = 0;
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const Solid solid = unite(test::resting_pipes(8, seed));
    ASSERT_TRUE(solid.contacts().empty());
    const Rounded before = rounded(solid);
    touching += before.contacts().empty() ? 0 : 1;
    expect_parted(parted(before), before);
  }
  EXPECT_GT(touching, 1U);
}

// A sliver comes to lie, whole, on the other side of what it touched: it may have the sign it had,
// but not the depth.
TEST(ContactParting, drops_slivers_that_it_takes_through_what_they_touch) {
  std::vector<Solid> components;
  for (const TriMesh& mesh : test::plant({.seed = 1135, .components = 300})) {
    components.push_back(Solid::from(mesh));
  }
  const Rounded before = rounded(unite(components));
  ASSERT_FALSE(before.contacts().empty());
  expect_parted(parted(before), before);
}

// They find no room beside each other within some spacings; that was tried for minutes.
TEST(ContactParting, leaves_as_they_are_hundreds_of_wedges_about_one_edge) {
  const Rounded before = rounded(Solid::from(test::wedges(200)));
  const Rounded after = parted(before);
  EXPECT_EQ(after.contacts().size(), before.contacts().size());
  EXPECT_TRUE(after.report().parted.empty());
}

}  // namespace
}  // namespace dupin
