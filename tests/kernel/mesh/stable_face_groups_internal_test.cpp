#include <algorithm>
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checking/self_intersection.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/rounding.h"
#include "kernel/moved_points.h"
#include "kernel/torus.h"
#include "mesh/coincident_points.h"
#include "mesh/exact_mesh.h"
#include "mesh/stable_face_groups.h"
#include "rounding/edits/fault_tracker.h"
#include "rounding/point_rounding.h"
#include "support/pipe_cases.h"
#include "support/pipe_unions.h"
#include "support/shapes.h"

namespace dupin::mesh {
namespace {

using testing::IsEmpty;
using testing::Not;

std::size_t count(std::span<const std::uint8_t> marks) {
  return static_cast<std::size_t>(std::ranges::count(marks, 1));
}

TEST(StableTriangles, keep_apart_wherever_points_move) {
  std::mt19937 random(20261122);
  std::size_t given_up = 0, stable = 0, others = 0, faults = 0;
  for (int round = 0; round < 300; ++round) {
    TriMesh mesh = test::torus(6 + round % 9, 9 + round % 17, 2, 1);
    test::shake(mesh, 0.04 * (round % 20), random);
    const double margin = 0.1 * std::pow(0.5, round % 12);
    const checking::SelfIntersections found = checking::find_self_intersections(
        mesh.points, mesh.triangles, {.closed = round % 3 != 0, .margin = margin});
    const checking::SelfIntersections plain =
        checking::find_self_intersections(mesh.points, mesh.triangles);
    EXPECT_TRUE(found.pairs == plain.pairs && found.degenerate == plain.degenerate);
    if (found.stable.empty()) {
      ++given_up;
      continue;
    }
    ASSERT_EQ(found.stable.size(), mesh.triangles.size());
    stable += count(found.stable);
    others += mesh.triangles.size() - count(found.stable);
    for (int i = 0; i < 8; ++i) {
      const checking::SelfIntersections now = checking::find_self_intersections(
          test::moved_points(mesh.points, margin, random), mesh.triangles);
      faults += now.pairs.size();
      for (const checking::FacePair& pair : now.pairs) {
        ASSERT_FALSE(found.stable[pair.first] == 1 && found.stable[pair.second] == 1) << round;
      }
      for (const std::uint32_t face : now.degenerate) {
        ASSERT_EQ(found.stable[face], 0) << round;
      }
    }
  }
  EXPECT_GT(given_up, 20);
  EXPECT_GT(stable, 20000);
  EXPECT_GT(others, 10000);
  EXPECT_GT(faults, 20000);
}

TEST(StableTriangles, are_nearly_all_where_the_margin_is_small) {
  const TriMesh mesh = test::torus(64, 128, 2, 1);
  const auto stable = [&](double margin) {
    return count(checking::find_self_intersections(mesh.points, mesh.triangles,
                                                   {.closed = true, .margin = margin})
                     .stable);
  };
  EXPECT_EQ(stable(1e-7), mesh.triangles.size());
  EXPECT_GT(stable(1e-3), mesh.triangles.size() / 2);
  EXPECT_EQ(stable(1), 0);
  EXPECT_EQ(stable(0), 0) << "not asked for";
}

TEST(StableTriangles, are_not_sought_where_surfaces_touch) {
  TriMesh mesh = test::joined({test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 0}, {2, 2, 1})});
  EXPECT_THAT(
      checking::find_self_intersections(mesh.points, mesh.triangles, {.margin = 1e-6}).stable,
      IsEmpty());
}

const StableFaceGroups& classes(const Solid& solid) { return solid.exact().stable; }

TEST(StableClasses, of_a_solid_reach_as_far_as_rounding_to_binary32) {
  const Solid box = Solid::from(test::box({0, 0, 0}, {5, 2, 1}));
  EXPECT_EQ(classes(box).of_triangle, std::vector<std::uint32_t>(12, 0));
  ASSERT_EQ(classes(box).classes.size(), 1);
  EXPECT_EQ(classes(box).classes[0].largest, 5);
  EXPECT_EQ(classes(box).classes[0].reach, 0x1p-22);
  EXPECT_THAT(classes(Solid::from(test::box({0, 0, 0}, {1e6, 1e-3, 1}))).of_triangle, IsEmpty())
      << "rounding may press it flat";
}

TEST(StableClasses, hold_on_lattices_whose_steps_are_no_larger) {
  const Solid solid = Solid::from(test::box({0, 0, 0}, {5, 2, 1}));
  const auto apart = [&](const exact::FloatLattice& lattice, double step, bool shifted) {
    return groups_apart(classes(solid), lattice, step, shifted);
  };
  const exact::FloatLattice floats(Coordinates::binary32), doubles(Coordinates::binary64);
  EXPECT_THAT(apart(floats, 1, false), Not(IsEmpty()));
  EXPECT_THAT(apart(doubles, 1, false), Not(IsEmpty()));
  EXPECT_THAT(apart(floats, 0x1p-21, true), Not(IsEmpty()));
  EXPECT_THAT(apart(floats, 0x1p-20, true), IsEmpty());
  EXPECT_THAT(apart(exact::FloatLattice(Coordinates::binary64, 0x1p-20), 0x1p-20, false),
              IsEmpty());
}

TEST(StableClasses, of_results_are_those_of_triangles_left_whole) {
  const Solid a = Solid::from(test::box({0, 0, 0}, {4, 4, 4}));
  const Solid b = Solid::from(test::box({3, 1, 1}, {9, 2, 2}));
  const std::vector<Solid> both = {a, b};
  for (const Solid& solid : {unite(both), subtract(a, std::span(&b, 1)), intersect(both)}) {
    const StableFaceGroups& stable = classes(solid);
    ASSERT_EQ(stable.of_triangle.size(), solid.triangle_count());
    ASSERT_EQ(stable.classes.size(), 2);
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
      EXPECT_EQ(stable.of_triangle[f], is_whole ? source.operand : StableFaceGroups::kNone) << f;
      whole += is_whole ? 1 : 0;
    }
    EXPECT_LT(whole, solid.triangle_count());
  }
}

TEST(StableClasses, end_at_contacts) {
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
  const exact::FloatLattice lattice(coordinates);
  const rounding::RoundedPoints rounded = rounding::round_points(exact, lattice, origin);
  const auto twins = mesh::representatives_at_contacts(exact);
  const auto apart =
      groups_apart(exact.stable, lattice, lattice.step(rounded.largest), !origin.isZero(0));
  const auto marked = rounding::marked_faces(exact.triangles, rounded.moved);
  const auto bad = [&](std::span<const std::uint32_t> of_triangle) {
    return rounding::find_faults({rounded.on_lattice, exact.triangles, twins, of_triangle}, marked);
  };
  EXPECT_TRUE(bad(apart) == bad({}));
  return static_cast<std::size_t>(
      std::ranges::count_if(apart, [](std::uint32_t c) { return c != StableFaceGroups::kNone; }));
}

TEST(StableClasses, do_not_change_what_rounding_finds) {
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

TEST(StableClasses, of_pipe_cases_do_not_change_what_rounding_finds) {
  for (const char* name : {"tee_100k_rot", "header_10", "rack_small", "chain_10", "blend_1"}) {
    std::vector<Solid> operands;
    for (const TriMesh& mesh : test::pipe_case(name)) {
      operands.push_back(Solid::from(mesh));
    }
    EXPECT_GT(expect_the_same_faults(unite(operands), Coordinates::binary32), 0) << name;
  }
}

}  // namespace
}  // namespace dupin::mesh
