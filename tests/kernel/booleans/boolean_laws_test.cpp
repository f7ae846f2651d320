#include <random>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/boolean_expression.h"
#include "kernel/same_solid.h"
#include "support/grid_solids.h"
#include "support/shapes.h"

namespace dupin {
namespace {

Solid set(const char* expression, const std::map<std::string, Solid>& operands) {
  return evaluate(Expression::parse(expression), operands);
}

// Triples of random solids on a grid, and a box around all.
template <class Law>
void for_all_triples(const Law& law) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(777 + seed);
    std::map<std::string, Solid> operands;
    for (const char* name : {"a", "b", "c"}) {
      operands.emplace(name, test::random_grid_solid(random));
    }
    operands.emplace("all", Solid::from(test::box(Vec3::Constant(-1), Vec3::Constant(9))));
    law(operands);
  }
}

void expect_equal(const char* left, const char* right) {
  SCOPED_TRACE(std::string(left) + " = " + right);
  for_all_triples([&](const std::map<std::string, Solid>& operands) {
    test::expect_same_solid(set(left, operands), set(right, operands));
  });
}

TEST(BooleanLaws, commutative) {
  expect_equal("a + b", "b + a");
  expect_equal("a & b", "b & a");
}

TEST(BooleanLaws, associative_in_one_arrangement_and_in_two) {
  expect_equal("(a + b) + c", "a + (b + c)");
  for_all_triples([](std::map<std::string, Solid> operands) {
    operands.emplace("ab", set("a + b", operands));
    operands.emplace("bc", set("b + c", operands));
    test::expect_same_solid(set("ab + c", operands), set("a + bc", operands));
    operands.insert_or_assign("ab", set("a & b", operands));
    operands.insert_or_assign("bc", set("b & c", operands));
    test::expect_same_solid(set("ab & c", operands), set("a & bc", operands));
  });
}

TEST(BooleanLaws, idempotent) {
  for_all_triples([](const std::map<std::string, Solid>& operands) {
    const Solid& a = operands.at("a");
    test::expect_same_solid(unite(std::vector{a, a, a}), a);
    test::expect_same_solid(intersect(std::vector{a, a}), a);
    EXPECT_TRUE(subtract(a, {&a, 1}).empty());
  });
}

TEST(BooleanLaws, distributive) {
  expect_equal("a & (b + c)", "(a & b) + (a & c)");
  expect_equal("a - (b + c)", "(a - b) - c");
}

TEST(BooleanLaws, of_de_morgan) {
  expect_equal("all - (a + b)", "(all - a) & (all - b)");
  expect_equal("all - (a & b)", "(all - a) + (all - b)");
}

TEST(BooleanLaws, inclusion_and_exclusion_exactly) {
  for_all_triples([](const std::map<std::string, Solid>& operands) {
    const auto volume = [&](const char* expression) {
      return set(expression, operands).exact_volume();
    };
    EXPECT_EQ(volume("a + b") + volume("a & b"), volume("a") + volume("b"));
    EXPECT_EQ(volume("a + b + c"), volume("a") + volume("b") + volume("c") - volume("a & b") -
                                       volume("b & c") - volume("a & c") + volume("a & b & c"));
  });
}

// Quarter turns about the axes and translations by whole numbers are exact in doubles.
Solid moved(const Solid& solid, const Eigen::Matrix3d& turn, const Vec3& by) {
  TriMesh mesh;
  mesh.triangles = solid.triangles();
  for (const Vec3& point : solid.nearest_points()) {
    mesh.points.push_back(turn * point + by);
  }
  return Solid::from(mesh);
}

TEST(BooleanLaws, do_not_depend_on_place_and_direction) {
  Eigen::Matrix3d about_z, cycle;
  about_z << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  cycle << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const struct {
    Eigen::Matrix3d turn;
    Vec3 by;
  } motions[] = {{about_z, Vec3::Zero()},
                 {cycle, Vec3::Zero()},
                 {about_z * cycle, Vec3(-5, 1000, 3)},
                 {Eigen::Matrix3d::Identity(), Vec3(0x1p30, -7, 0x1p20)}};
  for_all_triples([&](const std::map<std::string, Solid>& operands) {
    for (const auto& [turn, by] : motions) {
      std::map<std::string, Solid> elsewhere;
      for (const auto& [name, solid] : operands) {
        elsewhere.emplace(name, moved(solid, turn, by));
      }
      for (const char* expression : {"a + b", "a & b", "a - b", "(a + b) - c"}) {
        const Solid here = set(expression, operands), there = set(expression, elsewhere);
        EXPECT_EQ(here.exact_volume(), there.exact_volume());
        EXPECT_EQ(here.components(), there.components());
        EXPECT_EQ(here.genus(), there.genus());
        EXPECT_EQ(here.contacts().empty(), there.contacts().empty());
      }
    }
  });
}

}  // namespace
}  // namespace dupin
