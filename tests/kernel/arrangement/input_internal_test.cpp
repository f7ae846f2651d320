#include <set>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "kernel/arrangement/stages_internal.h"

namespace dupin::arrangement {
namespace {

using test::cube;
using test::Stages;

std::set<PointId> corners_in_use(const ArrangementInput& input) {
  std::set<PointId> result;
  for (const Triangle& t : input.triangles) {
    result.insert(t.begin(), t.end());
  }
  return result;
}

std::size_t merged_count(const ArrangementInput& input) {
  return static_cast<std::size_t>(std::count(input.merged.begin(), input.merged.end(), 1));
}

// A tetrahedron below the first octant, whose top is the bottom of test::tetrahedron().
TriMesh hanging_tetrahedron() {
  TriMesh mesh = test::tetrahedron();
  for (Vec3& p : mesh.points) {
    p.z() = -p.z();
  }
  return test::reversed(mesh);
}

TEST(Scene, welds_points_that_operands_have_in_common) {
  const Stages apart({cube(0, 0, 0), cube(5, 0, 0)});
  EXPECT_EQ(corners_in_use(apart.input).size(), 16);
  const Stages beside({cube(0, 0, 0), cube(2, 0, 0)});
  EXPECT_EQ(corners_in_use(beside.input).size(), 12);
  for (const PointId id : corners_in_use(beside.input)) {
    EXPECT_EQ(beside.input.special[id] != 0, beside.input.points.coordinates(id).x() == 2);
  }
}

TEST(Scene, pairs_operands_whose_bounds_overlap) {
  const Stages s({cube(0, 0, 0), cube(1, 1, 1), cube(9, 9, 9), cube(3, 3, 3)});
  using Pairs = std::vector<std::array<std::uint32_t, 2>>;
  EXPECT_EQ(s.input.operand_pairs, (Pairs{{0, 1}, {1, 3}}));
}

TEST(Scene, knows_the_operand_of_a_triangle) {
  const Stages s({test::tetrahedron(), cube(0, 0, 0), test::tetrahedron()});
  const std::uint32_t first[] = {0, 4, 16, 20};
  EXPECT_TRUE(std::equal(s.input.first_triangle.begin(), s.input.first_triangle.end(), first));
  for (std::uint32_t o = 0; o < 3; ++o) {
    EXPECT_EQ(s.input.operand_of(first[o]), o);
    EXPECT_EQ(s.input.operand_of(first[o + 1] - 1), o);
  }
}

TEST(Scene, keeps_one_of_coincident_triangles_of_equal_orientation) {
  const Stages s({cube(0, 0, 0), cube(0, 0, 0), cube(0, 0, 0)});
  EXPECT_EQ(merged_count(s.input), 24);
  ASSERT_EQ(s.input.duplicates.size(), 24);
  for (std::uint32_t t = 0; t < 12; ++t) {
    EXPECT_EQ(s.input.merged[t], 0);
    EXPECT_EQ(s.input.cover(t), (std::vector<SignedTriangle>{{t, 1}, {t + 12, 1}, {t + 24, 1}}));
  }
}

TEST(Scene, drops_coincident_triangles_that_cancel) {
  const std::vector<TriMesh> meshes{test::tetrahedron(), hanging_tetrahedron()};
  const Stages united(meshes);
  EXPECT_EQ(merged_count(united.input), 2);
  EXPECT_TRUE(united.input.duplicates.empty());
  // Of two groups, each counts for itself.
  const Stages subtracted(meshes, difference_rule(2));
  EXPECT_EQ(merged_count(subtracted.input), 1);
  ASSERT_EQ(subtracted.input.duplicates.size(), 1);
  EXPECT_EQ(subtracted.input.duplicates[0].copy.sign, -1);
}

TEST(Scene, welds_implicit_points_by_their_exact_place) {
  // The same cut, made twice: its points are no doubles, and their definitions differ.
  const std::vector<Solid> solids{Solid::from(cube(-3, -3, -3, 4)),
                                  Solid::from(test::slanted_tetrahedron())};
  const Solid a = dupin::intersect(solids), b = subtract(solids[0], std::span(solids).subspan(1));
  ASSERT_FALSE(a.exact().implicit.empty());
  const std::vector<const mesh::ExactMesh*> operands{&a.exact(), &b.exact()};
  const UpwardRounding rounding;
  const ArrangementInput input = load_operands(operands, union_rule(2));
  const std::set<PointId> used = corners_in_use(input);
  std::set<std::array<std::string, 3>> places;
  for (const PointId id : used) {
    const mesh::ExactPoint p = input.points.exact_value(id);
    std::array<std::string, 3> place;
    for (std::size_t k = 0; k < 3; ++k) {
      place[k] = mpq_class(exact::rational(p[k]) / exact::rational(p[3])).get_str();
    }
    places.insert(place);
  }
  EXPECT_EQ(places.size(), used.size());
  // Twins and points that only span planes.
  ASSERT_LT(used.size(), input.points.size());
  for (PointId id = 0; id < input.points.size(); ++id) {
    EXPECT_TRUE(input.special[id] != 0 || used.count(id) != 0) << id;
  }
}

TEST(Scene, knows_the_operand_of_a_point) {
  const Solid cut = dupin::intersect(
      std::vector{Solid::from(cube(-3, -3, -3, 4)), Solid::from(test::slanted_tetrahedron())});
  const Solid beside = Solid::from(cube(9, 9, 9));
  ASSERT_FALSE(cut.exact().implicit.empty());
  const std::vector<const mesh::ExactMesh*> operands{&beside.exact(), &cut.exact(),
                                                     &beside.exact()};
  const UpwardRounding rounding;
  const ArrangementInput input = load_operands(operands, union_rule(3));
  for (std::uint32_t t = 0; t < input.first_triangle[2]; ++t) {
    if (!input.merged[t]) {
      for (const PointId id : input.triangles[t]) {
        EXPECT_EQ(input.operand_of_point(id), input.operand_of(t));
      }
    }
  }
}

}  // namespace
}  // namespace dupin::arrangement
