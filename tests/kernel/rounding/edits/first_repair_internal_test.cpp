#include <algorithm>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/check.h"
#include "kernel/torus.h"
#include "rounding/edits/first_repair.h"

namespace dupin::rounding {
namespace {

/// A fine torus, a point of which rounding has taken through the other side of the tube.
struct Broken : testing::Test {
  Broken() : shape(test::torus(96, 192, 2, 1)), on_lattice(shape.points) {
    std::iota(own.begin(), own.end(), 0U);
    for (Vec3& p : shape.points) {
      p = lattice.nearest(p);
    }
    on_lattice = shape.points;
  }
  /// Moves a point of triangle 100, of the rounded mesh only.
  void move(const Vec3& by) { on_lattice[shape.triangles[100][0]] += by; }
  [[nodiscard]] BrokenMesh view() const {
    return {shape.points, on_lattice, shape.triangles, {}, own};
  }
  [[nodiscard]] std::vector<Fault> faults() const {
    return find_faults({on_lattice, shape.triangles, own},
                       std::vector<std::uint8_t>(shape.triangles.size(), 1));
  }
  [[nodiscard]] RepairLimits limits(double reach) const { return {lattice, 0x1p-20, reach, false}; }

  const exact::FloatLattice lattice{Coordinates::binary64, 0x1p-20};
  TriMesh shape;
  std::vector<Vec3> on_lattice;
  std::vector<std::uint32_t> own = std::vector<std::uint32_t>(shape.points.size());
};

TEST_F(Broken, is_repaired_in_a_part) {
  const Vec3 near = shape.points[shape.triangles[100][1]];
  move(1.25 * (near - shape.points[shape.triangles[100][0]]));
  const auto pairs = faults();
  ASSERT_FALSE(pairs.empty());
  const auto repair = first_repair_in_part(view(), faces_of(pairs), pairs, limits(0.1), 0.1);
  ASSERT_TRUE(repair);
  ASSERT_TRUE(repair->part);
  EXPECT_TRUE(repair->mesh->faults().empty());
  EXPECT_EQ(repair->mesh->face_count(), repair->part->faces().size());
  EXPECT_LT(repair->mesh->face_count(), shape.triangles.size());
}

TEST_F(Broken, is_given_whole_where_faults_are_left) {
  const Vec3 near = shape.points[shape.triangles[100][1]];
  move(1.25 * (near - shape.points[shape.triangles[100][0]]));
  const auto pairs = faults();
  ASSERT_FALSE(pairs.empty());
  // Nothing may move so little.
  const auto repair = first_repair_in_part(view(), faces_of(pairs), pairs, limits(0x1p-30), 0.1);
  ASSERT_TRUE(repair);
  EXPECT_FALSE(repair->part);
  const FirstRepair all = first_repair(view(), faces_of(pairs), pairs, limits(0x1p-30));
  const EditedMesh &mesh = *repair->mesh, &expected = *all.mesh;
  EXPECT_TRUE(mesh.faults() == pairs);
  EXPECT_TRUE(mesh.faults() == expected.faults());
  EXPECT_TRUE(std::ranges::equal(mesh.points(), expected.points()));
  EXPECT_TRUE(std::ranges::equal(mesh.triangles(), expected.triangles()));
  for (std::uint32_t v = 0; v < shape.points.size(); ++v) {
    EXPECT_EQ(mesh.reach(v), expected.reach(v));
  }
}

TEST_F(Broken, is_repaired_whole_where_the_part_is_not_small) {
  move(Vec3(0, 0, 1));
  std::vector<std::uint32_t> broken(shape.triangles.size() / 2);
  std::iota(broken.begin(), broken.end(), 0U);
  EXPECT_FALSE(first_repair_in_part(view(), broken, {}, limits(0.1), 0.1));
}

}  // namespace
}  // namespace dupin::rounding
