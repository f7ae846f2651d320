#include "dupin/kernel/cross_check.h"

#include <new>
#include <random>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/error.h"
#include "support/grid_solids.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using testing::HasSubstr;
using Verdict = CrossCheck::Verdict;

constexpr CrossCheckEngine kEngines[] = {CrossCheckEngine::nef, CrossCheckEngine::corefinement};
constexpr SetOperation kOperations[] = {SetOperation::unite, SetOperation::intersect,
                                        SetOperation::subtract};

Solid box(const Vec3& low, const Vec3& high) { return Solid::from(test::box(low, high)); }
Solid cube(double low, double high) { return box(Vec3::Constant(low), Vec3::Constant(high)); }

Solid ours(SetOperation operation, std::span<const Solid> operands) {
  return operation == SetOperation::unite       ? unite(operands)
         : operation == SetOperation::intersect ? intersect(operands)
                                                : subtract(operands[0], operands.subspan(1));
}

// How many checks end so, and none in a disagreement.
struct Tally {
  std::size_t agree = 0;

  void add(const CrossCheck& check) {
    ASSERT_NE(check.verdict, Verdict::disagrees);
    EXPECT_FALSE(check.place);
    EXPECT_EQ(check.failure.empty(), check.verdict == Verdict::agrees);
    if (check.verdict == Verdict::agrees) {
      EXPECT_EQ(check.volume, check.other_volume);
    }
    agree += check.verdict == Verdict::agrees ? 1 : 0;
  }
};

template <class MakeSolid>
Tally checked_on(int count, CrossCheckEngine engine, const MakeSolid& make) {
  Tally tally;
  for (int i = 0; i < count; ++i) {
    const std::vector<Solid> operands = {make(), make(), make()};
    for (const SetOperation operation : kOperations) {
      SCOPED_TRACE(std::to_string(i) + " " + std::string(name(operation)));
      tally.add(second_opinion(ours(operation, operands), engine, operation, operands));
    }
  }
  return tally;
}

// They share planes, edges and vertices, and results touch themselves.
TEST(CrossCheck, agrees_on_random_solids_on_a_grid) {
  std::mt19937 random(14);
  const Tally tally =
      checked_on(20, CrossCheckEngine::nef, [&] { return test::random_grid_solid(random); });
  EXPECT_EQ(tally.agree, 60U);
}

TEST(CrossCheck, agrees_on_random_boxes_in_general_position) {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> low(-2, 0), high(0.5, 2);
  const auto random_box = [&] {
    return box(Vec3(low(random), low(random), low(random)),
               Vec3(high(random), high(random), high(random)));
  };
  for (const CrossCheckEngine engine : kEngines) {
    EXPECT_EQ(checked_on(20, engine, random_box).agree, 60U) << name(engine);
  }
}

// Turned so that no coordinate of a new point is a double.
TEST(CrossCheck, agrees_on_points_that_no_double_holds) {
  std::vector<Solid> tubes;
  for (int i = 0; i < 4; ++i) {
    TriMesh tube = test::tube(1, -3, 3, 7);
    const Eigen::AngleAxisd turn(0.37 * i + 0.1, Vec3(1, 0.3 * i, 0.7).normalized());
    for (Vec3& point : tube.points) {
      point = turn * point;
    }
    tubes.push_back(Solid::from(tube));
  }
  for (const CrossCheckEngine engine : kEngines) {
    for (const SetOperation operation : kOperations) {
      SCOPED_TRACE(std::string(name(engine)) + " " + std::string(name(operation)));
      const Solid result = ours(operation, tubes);
      ASSERT_TRUE(result.contacts().empty());
      const CrossCheck check = second_opinion(result, engine, operation, tubes);
      EXPECT_EQ(check.verdict, Verdict::agrees) << check.failure;
      EXPECT_EQ(check.other_volume, result.exact_volume());
      EXPECT_EQ(combine_by(engine, operation, tubes).exact_volume(), result.exact_volume());
    }
  }
}

TEST(CrossCheck, agrees_on_expressions) {
  const std::map<std::string, Solid> operands{
      {"a", cube(0, 4)}, {"b", cube(3, 6)}, {"c", cube(2, 5)}, {"unused", cube(0, 1)}};
  for (const char* text :
       {"a + b - c", "a - (b - c)", "(a - b) & c", "a + (b & c)", "a - a", "b"}) {
    const Expression expression = Expression::parse(text);
    const Solid result = evaluate(expression, operands);
    for (const CrossCheckEngine engine : kEngines) {
      SCOPED_TRACE(std::string(text) + " " + std::string(name(engine)));
      const CrossCheck check = second_opinion(result, engine, expression, operands);
      EXPECT_EQ(check.verdict, Verdict::agrees) << check.failure;
      EXPECT_EQ(evaluate_by(engine, expression, operands).exact_volume(), result.exact_volume());
    }
  }
}

TEST(CrossCheck, finds_wrong_results_and_where_they_are_wrong) {
  const std::vector<Solid> both = {cube(0, 2), cube(1, 3)};
  const struct {
    SetOperation operation;
    Solid wrong;
    int volume, other_volume;
    Vec3 place;
  } table[] = {
      {SetOperation::unite, both[0], 8, 15, {1, 1, 2}},
      {SetOperation::unite, cube(0, 3), 27, 15, {0, 0, 2}},
      {SetOperation::unite, {}, 0, 15, {0, 0, 0}},
      {SetOperation::intersect, both[1], 8, 1, {1, 1, 2}},
      {SetOperation::subtract, both[0], 8, 7, {1, 1, 1}},
      // Of the right volume.
      {SetOperation::intersect, cube(5, 6), 1, 1, {1, 1, 1}},
  };
  for (const CrossCheckEngine engine : kEngines) {
    for (const auto& row : table) {
      const CrossCheck check = second_opinion(row.wrong, engine, row.operation, both);
      EXPECT_EQ(check.engine, engine);
      EXPECT_EQ(check.volume, row.volume);
      EXPECT_EQ(check.other_volume, row.other_volume);
      EXPECT_EQ(check.failure, "");
      EXPECT_EQ(check.verdict, Verdict::disagrees);
      EXPECT_EQ(check.place, row.place);
    }
  }
}

TEST(CrossCheck, finds_the_least_error) {
  const std::vector<Solid> both = {cube(0, 2), cube(1, 3)};
  TriMesh wrong{unite(both).nearest_points(), unite(both).triangles()};
  wrong.points[0] += Vec3(0, 0, 0x1p-52);
  for (const CrossCheckEngine engine : kEngines) {
    const CrossCheck check = second_opinion(Solid::from(wrong), engine, SetOperation::unite, both);
    EXPECT_EQ(check.verdict, Verdict::disagrees);
    ASSERT_TRUE(check.place);
  }
}

TEST(CrossCheck, takes_results_that_touch_themselves_by_nef_polyhedra_only) {
  const std::vector<Solid> along_an_edge = {cube(0, 1), box(Vec3(1, 1, 0), Vec3(2, 2, 1))};
  const Solid united = unite(along_an_edge);
  ASSERT_EQ(united.contacts().size(), 1U);
  EXPECT_EQ(
      second_opinion(united, CrossCheckEngine::nef, SetOperation::unite, along_an_edge).verdict,
      Verdict::agrees);
  const CrossCheck failed =
      second_opinion(united, CrossCheckEngine::corefinement, SetOperation::unite, along_an_edge);
  EXPECT_EQ(failed.verdict, Verdict::engine_failed);
  EXPECT_EQ(failed.failure,
            "'unite' by corefinement refuses a result that touches itself along an edge");
  EXPECT_EQ(failed.volume, 2);
  EXPECT_EQ(failed.other_volume, 0);
  EXPECT_FALSE(failed.place);
}

TEST(CrossCheck, takes_operands_of_which_shells_touch_by_nef_polyhedra_only) {
  const Solid pair = unite(std::vector{cube(0, 1), box(Vec3(1, 1, 0), Vec3(2, 2, 1))});
  const std::vector<Solid> operands = {pair, cube(0.5, 1.5)};
  const Solid united = unite(operands);
  EXPECT_EQ(second_opinion(united, CrossCheckEngine::nef, SetOperation::unite, operands).verdict,
            Verdict::agrees);
  EXPECT_EQ(
      second_opinion(united, CrossCheckEngine::corefinement, SetOperation::unite, operands).verdict,
      Verdict::engine_failed);
  // A frame of four cubes, of which two touch along an edge.
  const std::vector<Solid> bent = {unite(std::vector{cube(0, 1), box(Vec3(1, 1, 0), Vec3(2, 2, 1)),
                                                     box(Vec3(0, 0, 1), Vec3(2, 2, 2))}),
                                   cube(0.5, 1.5)};
  ASSERT_EQ(bent[0].shells(), 1U);
  ASSERT_FALSE(bent[0].contacts().empty());
  const CrossCheck failed =
      second_opinion(unite(bent), CrossCheckEngine::nef, SetOperation::unite, bent);
  EXPECT_EQ(failed.verdict, Verdict::engine_failed);
  EXPECT_THAT(failed.failure, HasSubstr("takes no operand of which a shell touches itself"));
}

TEST(CrossCheck, takes_voids_and_what_floats_in_them) {
  const Solid hollow = subtract(cube(0, 8), std::vector{cube(1, 7)});
  const std::vector<Solid> operands = {unite(std::vector{hollow, cube(2, 6)}), cube(3, 9)};
  for (const CrossCheckEngine engine : kEngines) {
    for (const SetOperation operation : kOperations) {
      EXPECT_EQ(second_opinion(ours(operation, operands), engine, operation, operands).verdict,
                Verdict::agrees);
    }
  }
}

TEST(CrossCheck, agrees_on_empty_sets) {
  const std::vector<Solid> apart = {cube(0, 1), cube(2, 3)}, with_empty = {cube(0, 1), {}};
  for (const CrossCheckEngine engine : kEngines) {
    EXPECT_EQ(second_opinion({}, engine, SetOperation::intersect, apart).verdict, Verdict::agrees);
    EXPECT_EQ(second_opinion({}, engine, SetOperation::unite, {}).verdict, Verdict::agrees);
    EXPECT_EQ(
        second_opinion({}, engine, SetOperation::subtract, std::vector{apart[0], apart[0]}).verdict,
        Verdict::agrees);
    for (const SetOperation operation : kOperations) {
      EXPECT_EQ(second_opinion(ours(operation, with_empty), engine, operation, with_empty).verdict,
                Verdict::agrees);
    }
    EXPECT_TRUE(combine_by(engine, SetOperation::intersect, apart).empty());
  }
}

TEST(CrossCheck, tells_its_progress_and_can_be_cancelled) {
  const std::vector<Solid> four = {cube(0, 2), cube(1, 3), cube(2, 4), cube(3, 5)};
  const Solid united = unite(four);
  for (const CrossCheckEngine engine : kEngines) {
    std::vector<double> fractions;
    (void)second_opinion(united, engine, SetOperation::unite, four,
                         [&](std::string_view stage, double fraction) {
                           EXPECT_EQ(stage, "cross-check");
                           fractions.push_back(fraction);
                           return true;
                         });
    EXPECT_THAT(fractions, testing::ElementsAre(0, 1.0 / 3, 2.0 / 3));
    try {
      (void)second_opinion(united, engine, SetOperation::unite, four,
                           [](std::string_view, double fraction) { return fraction < 0.5; });
      FAIL() << "should have thrown";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::cancelled);
    }
  }
}

TEST(CrossCheck, needs_all_operands_of_an_expression) {
  try {
    (void)second_opinion({}, CrossCheckEngine::nef, Expression::parse("a + b"),
                         {{"a", cube(0, 1)}});
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::invalid_argument);
    EXPECT_EQ(error.part(), "b");
  }
}

// What the caller throws, with which the engines' own failures have their types in common.
template <class Fault>
void expect_passed_on(const Fault& fault) {
  const std::vector<Solid> two = {cube(0, 2), cube(1, 3)};
  const Solid united = unite(two);
  const Progress progress = [&](std::string_view, double) -> bool { throw Fault(fault); };
  for (const CrossCheckEngine engine : kEngines) {
    EXPECT_THROW((void)second_opinion(united, engine, SetOperation::unite, two, progress), Fault);
    EXPECT_THROW((void)combine_by(engine, SetOperation::unite, two, progress), Fault);
    const std::map<std::string, Solid> named = {{"a", two[0]}, {"b", two[1]}};
    const Expression expression = Expression::parse("a + b");
    EXPECT_THROW((void)second_opinion(united, engine, expression, named, progress), Fault);
    EXPECT_THROW((void)evaluate_by(engine, expression, named, progress), Fault);
  }
}

class OfTheCaller : public Error {
 public:
  OfTheCaller() : Error(Errc::boolean_failed, "mine") {}
};

TEST(CrossCheck, passes_on_what_the_callers_callback_throws) {
  struct Mine {};
  expect_passed_on(Mine());
  expect_passed_on(std::bad_alloc());
  expect_passed_on(std::runtime_error("mine"));
  expect_passed_on(OfTheCaller());
}

}  // namespace
}  // namespace dupin
