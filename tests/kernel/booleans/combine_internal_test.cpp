#include <gtest/gtest.h>

#include "booleans/combine.h"
#include "dupin/kernel/error.h"
#include "mesh/exact_mesh.h"
#include "support/shapes.h"

namespace dupin::booleans {
namespace {

using arrangement::BooleanRule;

Solid cube(double low, double high) {
  return Solid::from(test::box(Vec3::Constant(low), Vec3::Constant(high)));
}

mpq_class volume(const std::vector<Solid>& operands, const BooleanRule& rule) {
  return Solid(std::make_shared<const mesh::ExactMesh>(combine(operands, rule, {}))).exact_volume();
}

// Three cubes of 8, of which two neighbours share a cube of 1.
TEST(Combine, follows_any_rule_about_groups_of_operands) {
  const std::vector<Solid> three = {cube(0, 2), cube(1, 3), cube(2, 4)};
  const auto counts = [](auto inside) { return BooleanRule{{0, 0, 0}, 1, inside}; };
  EXPECT_EQ(volume(three, counts([](auto count) { return count[0] % 2 == 1; })), 24 - 4);
  EXPECT_EQ(volume(three, counts([](auto count) { return count[0] == 2; })), 2);
  const BooleanRule outer_without_middle{
      {0, 1, 0}, 2, [](auto count) { return count[0] > 0 && count[1] == 0; }};
  EXPECT_EQ(volume(three, outer_without_middle), 16 - 2);
}

// Unlike unite(), which sorts them.
TEST(Combine, numbers_operands_as_they_are_given) {
  const std::vector<Solid> apart = {cube(5, 6), cube(0, 1), cube(2, 3)};
  const mesh::ExactMesh result = combine(apart, arrangement::union_rule(3), {});
  ASSERT_EQ(result.sources.size(), 36U);
  for (std::size_t i = 0; i < result.sources.size(); ++i) {
    const Vec3& corner = result.points[result.triangles[i][0]];
    const double operand = result.sources[i].operand;
    EXPECT_EQ(operand, corner.x() >= 5 ? 0 : corner.x() < 2 ? 1 : 2);
  }
}

Solid labelled_cube(const Vec3& low, const std::string& label) {
  return Solid::from(test::labelled(test::box(low, low + Vec3::Ones()), label));
}

TEST(Combine, refuses_contacts_if_told_to) {
  const Vec3 places[] = {Vec3::Zero(), Vec3(1, 1, 0), Vec3(0, 0, 3), Vec3(1, 1, 4)};
  std::vector<Solid> cubes;
  for (const Vec3& place : places) {
    cubes.push_back(labelled_cube(place, place.z() == 0 ? "low" : "high"));
  }
  const BooleanRule rule = arrangement::union_rule(cubes.size());
  EXPECT_EQ(combine(cubes, rule, {}).contacts.size(), 2U);
  try {
    (void)combine(cubes, rule, {.contacts = ContactPolicy::refuse});
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::contact);
    EXPECT_EQ(error.part(), "low");
    EXPECT_EQ(error.message(), "the result touches itself in 2 places, first at (1, 1, 0)");
  }
  const std::vector<Solid> crossing = {cube(0, 2), cube(1, 3)};
  EXPECT_NO_THROW(
      (void)combine(crossing, arrangement::union_rule(2), {.contacts = ContactPolicy::refuse}));
}

TEST(Combine, keeps_to_the_memory_it_is_given) {
  const std::vector<Solid> crossing = {cube(0, 2), cube(1, 3)};
  try {
    (void)combine(crossing, arrangement::union_rule(2), {.memory_limit = 1});
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
  }
}

}  // namespace
}  // namespace dupin::booleans
