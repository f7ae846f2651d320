#include "dupin/kernel/contacts.h"

#include <cfenv>
#include <cmath>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/error.h"
#include "support/message_of.h"
#include "support/shapes.h"

namespace dupin {
namespace {

Solid cubes(const Vec3& offset) {
  const TriMesh cube = test::labelled(test::box(Vec3::Zero(), Vec3::Constant(2)), "cube");
  return unite(std::vector{Solid::from(cube), Solid::from(test::moved(cube, offset))});
}

const Vec3 kVertex(2, 2, 2), kEdge(2, 2, 0);

// The corners of the tools are nearer than the length by this factor.
constexpr double kLength = 0.25, kSize = kLength * (1 - 0x1p-12);
constexpr double kOctahedron = 4.0 / 3 * kSize * kSize * kSize, kSquare = 2 * kSize * kSize;

TEST(Contacts, are_separated_by_taking_little_away) {
  const Settled vertex = separate(cubes(kVertex), kLength);
  EXPECT_EQ(vertex.contacts.size(), 1U);
  EXPECT_TRUE(vertex.solid.contacts().empty());
  EXPECT_EQ(vertex.solid.components(), 2U);
  EXPECT_NEAR(vertex.solid.volume(), 16 - kOctahedron / 4, 1e-14);

  const Settled edge = separate(cubes(kEdge), kLength);
  EXPECT_EQ(edge.contacts.at(0).kind, Contact::Kind::edge);
  EXPECT_TRUE(edge.solid.contacts().empty());
  EXPECT_EQ(edge.solid.components(), 2U);
  EXPECT_NEAR(edge.solid.volume(), 16 - 2 * kSquare / 2, 1e-14);
}

TEST(Contacts, are_bridged_by_adding_little) {
  const Settled vertex = bridge(cubes(kVertex), kLength);
  EXPECT_TRUE(vertex.solid.contacts().empty());
  EXPECT_EQ(vertex.solid.components(), 1U);
  EXPECT_NEAR(vertex.solid.volume(), 16 + kOctahedron * 3 / 4, 1e-14);

  const Settled edge = bridge(cubes(kEdge), kLength);
  EXPECT_TRUE(edge.solid.contacts().empty());
  EXPECT_EQ(edge.solid.components(), 1U);
  EXPECT_NEAR(edge.solid.volume(), 16 + 2 * kSquare / 2 + kOctahedron, 1e-14);
}

TEST(Contacts, settled_change_nothing_farther_than_the_length) {
  const Solid solid = cubes(kEdge);
  for (const Solid& settled : {separate(solid, kLength).solid, bridge(solid, kLength).solid}) {
    const mpq_class limit = mpq_class(kLength) * mpq_class(kLength);
    for (std::uint32_t i = 0; i < settled.triangle_count(); ++i) {
      if (settled.names()[settled.labels()[i]] != "contact") {
        EXPECT_EQ(settled.sources()[i].operand, 0U);
        continue;
      }
      for (const std::uint32_t corner : settled.triangles()[i]) {
        const auto p = settled.exact_point(corner);  // the contact: x = y = 2, z from 0 to 2
        const mpq_class x = p[0] - 2, y = p[1] - 2;
        const mpq_class z = p[2] < 0 ? p[2] : p[2] > 2 ? mpq_class(p[2] - 2) : mpq_class(0);
        EXPECT_LE(x * x + y * y + z * z, limit);
      }
    }
  }
}

TEST(Contacts, of_a_solid_without_any_need_no_settling) {
  const Solid cube = Solid::from(test::box(Vec3::Zero(), Vec3::Constant(2)));
  const Settled settled = separate(cube, 1);
  EXPECT_TRUE(settled.contacts.empty());
  EXPECT_EQ(settled.solid.triangles(), cube.triangles());
}

TEST(Contacts, are_not_settled_within_a_length_that_coordinates_hardly_hold) {
  for (const auto settle : {separate, bridge}) {
    EXPECT_NE(test::message_of([&] { (void)settle(cubes(kVertex), 1e-12, {}); }, Errc::contact)
                  .find("the length must be above 9.31323e-10"),
              std::string::npos);
  }
}

TEST(Contacts, are_settled_within_lengths_that_are_positive_whether_there_are_any_or_none) {
  const Solid cube = Solid::from(test::box(Vec3::Zero(), Vec3::Constant(2)));
  for (const double length : {0.0, -1.0, std::nan(""), double(INFINITY)}) {
    for (const auto settle : {separate, bridge}) {
      for (const Solid& solid : {cubes(kVertex), cube}) {
        EXPECT_NE(test::message_of([&] { (void)settle(solid, length, {}); }, Errc::invalid_argument)
                      .find("positive and finite"),
                  std::string::npos);
      }
    }
  }
}

// Two vertices whose tools meet in their tips at twice the length: smaller ones are taken.
TEST(Contacts, twice_the_length_apart_are_settled_all_the_same) {
  const TriMesh one = test::box({0, 0, 0}, {2, 2, 2});
  const Solid three =
      unite(std::vector{Solid::from(one), Solid::from(test::box({2, 2, 2}, {3, 3, 3})),
                        Solid::from(test::box({2, 2, -1}, {3, 3, 0}))});
  ASSERT_EQ(three.contacts().size(), 2U);
  for (const double length : {1.0, 1 / (1 - 0x1p-12)}) {
    const Settled settled = bridge(three, length);
    EXPECT_TRUE(settled.solid.contacts().empty());
    EXPECT_EQ(settled.solid.components(), 1U);
  }
}

TEST(Contacts, are_settled_in_the_usual_arithmetic) {
  const Solid touching = cubes(kEdge);
  for (const auto settle : {separate, bridge}) {
    const Solid usual = settle(touching, 0.3, {}).solid;
    std::fesetround(FE_UPWARD);
    const Solid upward = settle(touching, 0.3, {}).solid;
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(usual.exact_volume(), upward.exact_volume());
  }
}

}  // namespace
}  // namespace dupin
