#include <algorithm>
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bad_items.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/rounding.h"
#include "exact_mesh.h"
#include "exact_rounding.h"
#include "kernel/moved_points.h"
#include "kernel/torus.h"
#include "self_intersection.h"
#include "steady_classes.h"
#include "support/pipe_cases.h"
#include "support/pipe_unions.h"
#include "support/shapes.h"

namespace dupin::detail {
namespace {

using testing::IsEmpty;
using testing::Not;

std::size_t count(std::span<const std::uint8_t> marks) {
  return static_cast<std::size_t>(std::ranges::count(marks, 1));
}

TEST(SteadyTriangles, keep_apart_wherever_points_move) {
  std::mt19937 random(20261122);
  std::size_t given_up = 0, steady = 0, others = 0, faults = 0;
  for (int round = 0; round < 300; ++round) {
    TriMesh mesh = test::torus(6 + round % 9, 9 + round % 17, 2, 1);
    test::shake(mesh, 0.04 * (round % 20), random);
    const double margin = 0.1 * std::pow(0.5, round % 12);
    const SelfIntersections found = find_self_intersections(
        mesh.points, mesh.triangles, {.closed = round % 3 != 0, .margin = margin});
    const SelfIntersections plain = find_self_intersections(mesh.points, mesh.triangles);
    EXPECT_TRUE(found.pairs == plain.pairs && found.degenerate == plain.degenerate);
    if (found.steady.empty()) {
      ++given_up;
      continue;
    }
    ASSERT_EQ(found.steady.size(), mesh.triangles.size());
    steady += count(found.steady);
    others += mesh.triangles.size() - count(found.steady);
    for (int i = 0; i < 8; ++i) {
      const SelfIntersections now =
          find_self_intersections(test::moved_points(mesh.points, margin, random), mesh.triangles);
      faults += now.pairs.size();
      for (const FacePair& pair : now.pairs) {
        ASSERT_FALSE(found.steady[pair.first] == 1 && found.steady[pair.second] == 1) << round;
      }
      for (const std::uint32_t face : now.degenerate) {
        ASSERT_EQ(found.steady[face], 0) << round;
      }
    }
  }
  EXPECT_GT(given_up, 20);
  EXPECT_GT(steady, 20000);
  EXPECT_GT(others, 10000);
  EXPECT_GT(faults, 20000);
}

TEST(SteadyTriangles, are_nearly_all_where_the_margin_is_small) {
  const TriMesh mesh = test::torus(64, 128, 2, 1);
  const auto steady = [&](double margin) {
    return count(
        find_self_intersections(mesh.points, mesh.triangles, {.closed = true, .margin = margin})
            .steady);
  };
  EXPECT_EQ(steady(1e-7), mesh.triangles.size());
  EXPECT_GT(steady(1e-3), mesh.triangles.size() / 2);
  EXPECT_EQ(steady(1), 0);
  EXPECT_EQ(steady(0), 0) << "not asked for";
}

TEST(SteadyTriangles, are_not_sought_where_surfaces_touch) {
  TriMesh mesh = test::joined({test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 0}, {2, 2, 1})});
  EXPECT_THAT(find_self_intersections(mesh.points, mesh.triangles, {.margin = 1e-6}).steady,
              IsEmpty());
}

const SteadyClasses& classes(const Solid& solid) { return solid.exact().steady; }

TEST(SteadyClasses, of_a_solid_reach_as_far_as_rounding_to_binary32) {
  const Solid box = Solid::from(test::box({0, 0, 0}, {5, 2, 1}));
  EXPECT_EQ(classes(box).of_triangle, std::vector<std::uint32_t>(12, 0));
  ASSERT_EQ(classes(box).classes.size(), 1);
  EXPECT_EQ(classes(box).classes[0].largest, 5);
  EXPECT_EQ(classes(box).classes[0].reach, 0x1p-22);
  EXPECT_THAT(classes(Solid::from(test::box({0, 0, 0}, {1e6, 1e-3, 1}))).of_triangle, IsEmpty())
      << "rounding may press it flat";
}

TEST(SteadyClasses, hold_on_lattices_whose_steps_are_no_larger) {
  const Solid solid = Solid::from(test::box({0, 0, 0}, {5, 2, 1}));
  const auto apart = [&](const Lattice& lattice, double step, bool shifted) {
    return classes_apart(classes(solid), lattice, step, shifted);
  };
  const Lattice floats(Coordinates::binary32), doubles(Coordinates::binary64);
  EXPECT_THAT(apart(floats, 1, false), Not(IsEmpty()));
  EXPECT_THAT(apart(doubles, 1, false), Not(IsEmpty()));
  EXPECT_THAT(apart(floats, 0x1p-21, true), Not(IsEmpty()));
  EXPECT_THAT(apart(floats, 0x1p-20, true), IsEmpty());
  EXPECT_THAT(apart(Lattice(Coordinates::binary64, 0x1p-20), 0x1p-20, false), IsEmpty());
}

TEST(SteadyClasses, of_results_are_those_of_triangles_left_whole) {
  const Solid a = Solid::from(test::box({0, 0, 0}, {4, 4, 4}));
  const Solid b = Solid::from(test::box({3, 1, 1}, {9, 2, 2}));
  const std::vector<Solid> both = {a, b};
  for (const Solid& solid : {unite(both), subtract(a, std::span(&b, 1)), intersect(both)}) {
    const SteadyClasses& steady = classes(solid);
    ASSERT_EQ(steady.of_triangle.size(), solid.triangle_count());
    ASSERT_EQ(steady.classes.size(), 2);
    std::size_t whole = 0;
    for (std::uint32_t f = 0; f < solid.triangle_count(); ++f) {
      const Source& source = solid.sources()[f];
      const Solid& operand = both[source.operand];
      const auto places = [](const Solid& of, std::uint32_t face) {
        std::vector<std::array<double, 3>> corners;
        for (const std::uint32_t v : of.triangles()[face]) {
          const Vec3& p = of.nearest_points()[v];
          corners.push_back({p.x(), p.y(), p.z()});
        }
        std::ranges::sort(corners);
        return corners;
      };
      const bool is_whole = places(solid, f) == places(operand, source.triangle);
      EXPECT_EQ(steady.of_triangle[f], is_whole ? source.operand : SteadyClasses::kNone) << f;
      whole += is_whole ? 1 : 0;
    }
    EXPECT_LT(whole, solid.triangle_count());
  }
}

TEST(SteadyClasses, end_at_contacts) {
  const std::vector<Solid> both = {Solid::from(test::box({0, 0, 0}, {1, 1, 1})),
                                   Solid::from(test::box({1, 1, 0}, {2, 2, 1}))};
  const Solid touching = unite(both);
  EXPECT_THAT(touching.contacts(), Not(IsEmpty()));
  EXPECT_THAT(classes(touching).of_triangle, IsEmpty());
  const std::vector<Solid> further = {touching, Solid::from(test::box({0, 0, 9}, {1, 1, 10}))};
  EXPECT_THAT(classes(unite(further)).of_triangle, IsEmpty());
}

/// Faults on the lattice, with the classes and without. Returns how many triangles have a class.
std::size_t expect_the_same_faults(const Solid& solid, Coordinates coordinates,
                                   const Vec3& origin = Vec3::Zero()) {
  const ExactMesh& exact = solid.exact();
  const Lattice lattice(coordinates);
  const RoundedPoints rounded = round_points(exact, lattice, origin);
  const auto twins = twins_at_contacts(exact);
  const auto apart =
      classes_apart(exact.steady, lattice, lattice.step(rounded.largest), !origin.isZero(0));
  const auto marked = marked_faces(exact.triangles, rounded.moved);
  const auto bad = [&](std::span<const std::uint32_t> of_triangle) {
    return find_bad_items({rounded.on_lattice, exact.triangles, twins, of_triangle}, marked);
  };
  EXPECT_TRUE(bad(apart) == bad({}));
  return static_cast<std::size_t>(
      std::ranges::count_if(apart, [](std::uint32_t c) { return c != SteadyClasses::kNone; }));
}

TEST(SteadyClasses, do_not_change_what_rounding_finds) {
  std::size_t known = 0;
  for (const auto& kinds : {std::span<const test::UnionKind>(test::kDesignKinds),
                            std::span<const test::UnionKind>(test::kPlantKinds)}) {
    for (const test::UnionKind kind : kinds) {
      for (std::uint32_t seed = 0; seed < 6; ++seed) {
        const std::vector<Solid> pipes = test::pipes(kind, 64, seed);
        for (const Solid& solid :
             {unite(pipes), subtract(pipes[0], std::span(pipes).subspan(1)), intersect(pipes),
              unite(std::vector{unite(pipes), Solid::from(test::box({-1, -1, -1}, {1, 2, 3}))})}) {
          known += expect_the_same_faults(solid, Coordinates::binary32);
          expect_the_same_faults(solid, Coordinates::binary64);
          known += expect_the_same_faults(solid, Coordinates::binary32, Vec3(8, 16, -4));
        }
      }
    }
  }
  EXPECT_GT(known, 20000);
}

TEST(SteadyClasses, of_pipe_cases_do_not_change_what_rounding_finds) {
  for (const char* name : {"tee_100k_rot", "header_10", "rack_small", "chain_10", "blend_1"}) {
    std::vector<Solid> operands;
    for (const TriMesh& mesh : test::pipe_case(name)) {
      operands.push_back(Solid::from(mesh));
    }
    EXPECT_GT(expect_the_same_faults(unite(operands), Coordinates::binary32), 0) << name;
  }
}

}  // namespace
}  // namespace dupin::detail
