#include <gtest/gtest.h>

#include "cross_check/pairwise.h"
#include "exact/exact_numbers.h"
#include "kernel/cross_check/cut_wedge_internal.h"

namespace dupin::cross_check {
namespace {

Solid box(const Vec3& low, const Vec3& high) { return Solid::from(test::box(low, high)); }
Solid cube(double low, double high) { return box(Vec3::Constant(low), Vec3::Constant(high)); }

struct Outcome {
  Solid solid;
  int corefinements = 0;
};

// The names a, b, c, ... stand for the operands in their order.
Outcome evaluate(const std::string& text, const std::vector<Solid>& operands) {
  const Expression expression = Expression::parse(text);
  std::vector<Solid> named;
  for (const std::string& name : expression.names()) {
    named.push_back(operands.at(static_cast<std::size_t>(name[0] - 'a')));
  }
  Outcome outcome;
  auto mesh = mesh_by_corefinement({expression.steps(), named}, [&](std::string_view, double) {
    ++outcome.corefinements;
    return true;
  });
  outcome.solid = Solid(std::make_shared<const mesh::ExactMesh>(std::move(mesh)));
  return outcome;
}

// Cubes of 8: a and b share 1, c and d share 1, e is alone; f is inside a.
TEST(Pairwise, corefines_only_where_boxes_meet) {
  const std::vector<Solid> all = {cube(0, 2),   cube(1, 3),   cube(10, 12),
                                  cube(11, 13), cube(20, 22), cube(0.5, 1)};
  const struct {
    const char* text;
    mpq_class volume;
    int corefinements;
  } table[] = {
      {"a", 8, 0},
      {"a + b", 15, 1},
      {"a + c + e", 24, 0},
      {"a + c + b + d", 30, 2},
      {"e + d + c + b + a", 38, 2},
      {"a & b", 1, 1},
      {"a & c", 0, 0},
      {"a & b & e", 0, 1},
      {"a & e & b", 0, 0},
      {"a - c - d - e", 8, 0},
      {"a - b - c", 7, 1},
      {"a - (b + c)", 7, 1},
      {"a - f", mpq_class(63, 8), 1},
      {"(a & c) + b", 8, 0},
      {"(a & c) & b", 0, 0},
      {"(a & c) - b", 0, 0},
      {"b - (a & c)", 8, 0},
  };
  for (const auto& row : table) {
    const Outcome outcome = evaluate(row.text, all);
    EXPECT_EQ(outcome.solid.exact_volume(), row.volume) << row.text;
    EXPECT_EQ(outcome.corefinements, row.corefinements) << row.text;
  }
}

// Sharing one point, the boxes may not be taken for disjoint.
TEST(Pairwise, corefines_where_boxes_only_touch) {
  const Outcome touching = evaluate("a + b", {cube(0, 1), box(Vec3(1, 0, 0), Vec3(2, 1, 1))});
  EXPECT_EQ(touching.corefinements, 1);
  EXPECT_EQ(touching.solid.shells(), 1U);
  EXPECT_EQ(touching.solid.exact_volume(), 2);
}

TEST(Pairwise, unites_groups_with_points_that_no_double_holds) {
  const Vec3 there(10, 0, 0);
  const Outcome outcome =
      evaluate("(a & b) + e + (c & d)",
               {Solid::from(test::wedge(Vec3::Zero())), Solid::from(test::slab(Vec3::Zero())),
                Solid::from(test::wedge(there)), Solid::from(test::slab(there)), cube(20, 21)});
  EXPECT_EQ(outcome.corefinements, 2);
  EXPECT_EQ(outcome.solid.exact_volume(), 2 * test::kCutWedgeVolume + 1);
  auto expected = test::sorted_points(test::cut_wedge(Vec3::Zero()));
  for (const Solid& other : {test::cut_wedge(there), cube(20, 21)}) {
    const auto more = test::sorted_points(other);
    expected.insert(expected.end(), more.begin(), more.end());
  }
  EXPECT_EQ(test::sorted_points(outcome.solid), expected) << "from left to right";
  const mesh::ExactMesh& mesh = outcome.solid.exact();
  EXPECT_EQ(mesh.implicit.size(), 4U);
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const mpq_class exact = outcome.solid.exact_point(i)[static_cast<std::size_t>(k)];
      EXPECT_EQ(mesh.points[i][k], exact::nearest_double(exact));
    }
  }
}

TEST(Pairwise, keeps_contacts_of_operands_and_nothing_else_of_them) {
  const Solid pair =
      Solid::from(test::labelled(test::joined({test::box(Vec3::Zero(), Vec3::Ones()),
                                               test::box(Vec3::Ones(), Vec3::Constant(2))}),
                                 "pair"));
  ASSERT_EQ(pair.contacts().size(), 1U);
  const Solid united = evaluate("a + b", {cube(7, 8), pair}).solid;
  EXPECT_EQ(united.contacts().size(), 1U);
  EXPECT_TRUE(united.labels().empty());
  EXPECT_EQ(united.sources().back(), (Source{0, 35}));
}

}  // namespace
}  // namespace dupin::cross_check
