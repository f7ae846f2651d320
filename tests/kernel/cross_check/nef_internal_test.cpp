#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cross_check/nef.h"
#include "kernel/cross_check/cut_wedge_internal.h"

namespace dupin::cross_check {
namespace {

Solid box(const Vec3& low, const Vec3& high) { return Solid::from(test::box(low, high)); }
Solid cube(double low, double high) { return box(Vec3::Constant(low), Vec3::Constant(high)); }

// An expression whose names a, b, c stand for the operands in their order.
struct Question {
  std::string text;
  std::vector<Solid> operands;

  template <class Ask>
  auto asked(const Ask& ask, const Progress& progress = {}) const {
    const Expression expression = Expression::parse(text);
    std::vector<Solid> named;
    for (const std::string& name : expression.names()) {
      named.push_back(operands.at(static_cast<std::size_t>(name[0] - 'a')));
    }
    return ask(Request{expression.steps(), named}, progress);
  }
};

Boundary boundary(const Question& question) { return question.asked(boundary_by_nef); }

mpq_class mesh_volume(const Question& question) {
  auto mesh = question.asked(mesh_by_nef);
  return Solid(std::make_shared<const mesh::ExactMesh>(std::move(mesh))).exact_volume();
}

TEST(Nef, cuts_to_the_very_points) {
  const Question cut{
      "a & b", {Solid::from(test::wedge(Vec3::Zero())), Solid::from(test::slab(Vec3::Zero()))}};
  const mpq_class third(1, 3);
  const Boundary expected{
      {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {2 * third, 1, 0}, {0, 1, 2 * third}},
      {{{0, 3}, {3, 4}, {4, 1}, {1, 0}},    // z = 0
       {{0, 1}, {1, 2}, {2, 0}},            // y = 0
       {{0, 2}, {2, 5}, {5, 3}, {3, 0}},    // x = 0
       {{3, 5}, {5, 4}, {4, 3}},            // y = 1
       {{1, 4}, {4, 5}, {5, 2}, {2, 1}}}};  // the slope
  ASSERT_EQ(volume(expected), test::kCutWedgeVolume);
  const Boundary by_nef = boundary(cut);
  EXPECT_EQ(by_nef.facets.size(), 5U);
  EXPECT_FALSE(corner_of_difference(by_nef, expected));
  EXPECT_EQ(mesh_volume(cut), test::kCutWedgeVolume);
}

TEST(Nef, facets_are_whole_and_may_have_holes) {
  const Question drilled{"a - b", {cube(0, 3), box(Vec3(1, 1, -1), Vec3(2, 2, 4))}};
  const Boundary by_nef = boundary(drilled);
  std::vector<std::size_t> sizes;
  for (const auto& facet : by_nef.facets) {
    sizes.push_back(facet.size());
  }
  EXPECT_THAT(sizes, testing::UnorderedElementsAre(8, 8, 4, 4, 4, 4, 4, 4, 4, 4));
  EXPECT_EQ(by_nef.points.size(), 16U);
  EXPECT_EQ(volume(by_nef), 27 - 3);
}

TEST(Nef, regularises_at_the_end) {
  // A common side of a and b that sticks out of c.
  const std::vector<Solid> touching = {cube(0, 2), box(Vec3(2, 0, 0), Vec3(3, 2, 2)),
                                       box(Vec3(1, 1, 1), Vec3(5, 5, 5))};
  EXPECT_TRUE(boundary({"a & b", touching}).facets.empty());
  EXPECT_EQ(mesh_volume({"a & b", touching}), 0);
  EXPECT_EQ(boundary({"a & b + c", touching}).facets.size(), 6U);
  EXPECT_EQ(mesh_volume({"a & b + c", touching}), 64);
  // Not before: the side that a and b have in common is no slit.
  EXPECT_EQ(boundary({"a + b", touching}).facets.size(), 6U);
  EXPECT_EQ(mesh_volume({"a + b", touching}), 12);
}

TEST(Nef, takes_voids_with_bodies_in_them) {
  const Solid nested =
      Solid::from(test::joined({test::box(Vec3::Zero(), Vec3::Constant(8)),
                                test::reversed(test::box(Vec3::Constant(1), Vec3::Constant(7))),
                                test::box(Vec3::Constant(2), Vec3::Constant(6))}));
  EXPECT_EQ(mesh_volume({"a", {nested}}), 512 - 216 + 64);
  // The half with x > 4.
  const Solid half = box(Vec3(4, -1, -1), Vec3(9, 9, 9));
  EXPECT_EQ(mesh_volume({"a & b", {nested, half}}), (512 - 216 + 64) / 2);
  EXPECT_EQ(mesh_volume({"b - a", {nested, half}}), 500 - 180);
}

template <class Ask>
std::string refusal(const Question& question, const Ask& ask) {
  try {
    (void)question.asked(ask);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::boolean_failed);
    return error.what();
  }
  return "not refused";
}

TEST(Nef, has_a_boundary_but_no_mesh_of_what_touches_itself) {
  const Question pair{"a + b", {cube(0, 1), box(Vec3(1, 1, 0), Vec3(2, 2, 1))}};
  const Boundary by_nef = boundary(pair);
  EXPECT_EQ(volume(by_nef), 2);
  EXPECT_EQ(by_nef.points.size(), 14U);
  EXPECT_EQ(refusal(pair, mesh_by_nef),
            "the operation by Nef polyhedra has a result whose boundary is no 2-manifold");
}

TEST(Nef, takes_shells_that_touch_but_none_that_touches_itself) {
  const TriMesh two = test::joined(
      {test::box(Vec3::Zero(), Vec3::Ones()), test::box(Vec3::Ones(), Vec3::Constant(2))});
  EXPECT_EQ(volume(boundary({"a - b", {Solid::from(two), cube(0.5, 1.5)}})), mpq_class(7, 4));
  // The same corner, and a bridge from one cube to the other around it.
  const Solid one = unite(std::vector{Solid::from(two), box(Vec3(-1, 0, 0), Vec3(0, 1, 3)),
                                      box(Vec3(-1, 0, 2), Vec3(2, 2, 3))});
  ASSERT_EQ(one.shells(), 1U);
  ASSERT_FALSE(one.contacts().empty());
  EXPECT_EQ(refusal({"a", {one}}, boundary_by_nef),
            "the operation by Nef polyhedra takes no operand of which a shell touches itself");
}

TEST(Nef, tells_of_each_operation) {
  std::vector<double> fractions;
  const Question question{"a + b + c", {cube(0, 1), cube(2, 3), cube(4, 5)}};
  const Progress progress = [&](std::string_view, double fraction) {
    fractions.push_back(fraction);
    return fractions.size() < 2;
  };
  try {
    (void)question.asked(boundary_by_nef, progress);
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::cancelled);
  }
  EXPECT_THAT(fractions, testing::ElementsAre(0, 0.5));
}

}  // namespace
}  // namespace dupin::cross_check
