#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "dupin/kernel/check.h"
#include "kernel/rounding/edits/edit_fixture_internal.h"
#include "rounding/edits/edit_strategy.h"

namespace dupin::rounding {
namespace {

TEST_F(Edit, repairs_what_random_moves_have_broken) {
  const exact::FloatLattice lattice(Coordinates::binary64, 0x1p-10);
  std::mt19937 random(17);
  std::uniform_int_distribution<int> offset(-200, 200);
  std::size_t broken = 0;
  for (int round = 0; round < 30; ++round) {
    take(test::tube(1, 0, 1, 64));
    for (Vec3& p : shape.points) {
      p = lattice.nearest(p) + Vec3(offset(random), offset(random), offset(random)) * 0x1p-10;
    }
    EditedMesh tube = mesh();
    tube.find_faults(std::vector<std::uint8_t>(shape.triangles.size(), 1));
    const std::size_t before = tube.faults().size();
    EXPECT_TRUE(mend_faults(tube, lattice, 2, {1'000'000, 1'000'000}));
    const Report after = check(result(tube));
    EXPECT_EQ(tube.faults().empty(),
              after.count(Defect::self_intersection) + after.count(Defect::degenerate_face) == 0)
        << "the books are right";
    EXPECT_TRUE(after.closed());
    EXPECT_LE(tube.faults().size(), before);
    broken += before > 0 && tube.faults().empty() ? 1 : 0;
  }
  EXPECT_GE(broken, 25) << "most can be repaired";
}

TEST_F(Edit, gives_up_when_its_trials_are_spent) {
  shape.points[0] = Vec3(0, 0, 5);  // through the top
  EditedMesh tube = mesh();
  tube.find_faults(std::vector<std::uint8_t>(shape.triangles.size(), 1));
  const std::vector<Fault> before = tube.faults();
  ASSERT_FALSE(before.empty());
  const exact::FloatLattice lattice(Coordinates::binary64, 0x1p-10);
  EXPECT_FALSE(mend_faults(tube, lattice, 1e-3, {1, 1}));
  EXPECT_TRUE(tube.faults() == before);
}

// What does not help a fault is not tried again because others are mended elsewhere.
TEST_F(Edit, is_tried_again_only_where_something_has_changed) {
  const exact::FloatLattice lattice(Coordinates::binary64, 0x1p-10);
  const auto trials = [&](const TriMesh& broken, std::size_t left) {
    take(broken);
    EditedMesh tube = mesh();
    tube.find_faults(std::vector<std::uint8_t>(shape.triangles.size(), 1));
    EXPECT_TRUE(mend_faults(tube, lattice, 0.25, {1'000'000, 1'000'000}));
    EXPECT_EQ(tube.faults().empty(), left == 0);
    return tube.trials();
  };
  TriMesh hopeless = test::tube(1, 0, 1, 8);
  hopeless.points[0] = Vec3(0, 0, 5);  // through the top
  TriMesh mended = test::tube(1, 0, 1, 64);
  std::mt19937 random(3);
  std::uniform_int_distribution<int> offset(-100, 100);
  for (Vec3& p : mended.points) {
    p = lattice.nearest(p) + Vec3(offset(random), offset(random), offset(random)) * 0x1p-10;
    p.x() += 10;
  }
  const std::uint64_t first = trials(hopeless, 1), second = trials(mended, 0);
  EXPECT_GT(first, 100U);
  EXPECT_GT(second, 10U);
  EXPECT_LE(trials(test::joined({hopeless, mended}), 1), first + second);
}

TEST_F(Edit, moves_points_in_vain_only_so_often) {
  shape.points[0] = Vec3(0, 0, 5);  // through the top
  const exact::FloatLattice lattice(Coordinates::binary64, 0x1p-10);
  EditedMesh with = mesh(), without = mesh();
  for (EditedMesh* tube : {&with, &without}) {
    tube->find_faults(std::vector<std::uint8_t>(shape.triangles.size(), 1));
    const bool moves = tube == &with;
    EXPECT_EQ(mend_faults(*tube, lattice, 0.25, {1'000'000, moves ? 1'000'000U : 0U}), moves);
    EXPECT_FALSE(tube->faults().empty());
  }
  EXPECT_LT(without.trials(), with.trials() / 4);
}

TEST_F(Edit, thickens_what_is_lower_than_the_reach) {
  shape.points[1] = shape.points[0] + Vec3(0, 1e-6, 0);  // next to another corner of the bottom
  std::vector<std::uint32_t> all(shape.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  EditedMesh tube = mesh();
  thicken(tube, 1e-4, all);
  const TriMesh thick = result(tube);
  EXPECT_TRUE(check(thick).is_solid());
  EXPECT_LT(thick.triangles.size(), shape.triangles.size());
  for (const Triangle& t : thick.triangles) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_GT((thick.points[t[k]] - thick.points[t[(k + 1) % 3]]).norm(), 1e-4);
    }
  }
}

// All edges around the tube are shorter than the reach.
TEST_F(Edit, repairs_further_near_the_broken_faces_only) {
  take(test::tube(1, 0, 1, 64));
  EditedMesh tube = mesh();
  const auto size = [&](std::uint32_t f) { return with_neighbours(tube, {f}).size(); };
  std::vector<std::uint32_t> faces(shape.triangles.size());
  std::iota(faces.begin(), faces.end(), 0);
  const std::uint32_t broken = *std::ranges::min_element(faces, {}, size);
  std::set<std::uint32_t> near;
  for (const std::uint32_t f : with_neighbours(tube, {broken})) {
    near.insert(tube.triangle(f).begin(), tube.triangle(f).end());
  }
  ASSERT_LT(near.size(), shape.points.size() / 4);
  const exact::FloatLattice lattice(Coordinates::binary64, 0x1p-10);
  EXPECT_TRUE(repair_further(tube, {broken}, {lattice, 0x1p-10, 0.12, true}));
  std::size_t gone = 0;
  for (std::uint32_t v = 0; v < shape.points.size(); ++v) {
    const bool is_as_it_was = !tube.faces(v).empty() && tube.point(v) == shape.points[v];
    EXPECT_TRUE(is_as_it_was || near.contains(v)) << v;
    gone += is_as_it_was ? 0 : 1;
  }
  EXPECT_GT(gone, 0U);
}

TEST_F(Edit, thickens_everywhere_what_doubles_hold) {
  shape.points[1] = shape.points[0] + Vec3(0, 1e-6, 0);
  const std::vector<std::uint8_t> inexact(shape.points.size(), 1);
  const BrokenMesh original{shape.points, shape.points, shape.triangles, labels, representatives};
  EditedMesh tube = mesh();
  EXPECT_TRUE(thicken_doubles(tube, original, inexact, 1e-4, 0x1p-50));
  const TriMesh thick = result(tube);
  EXPECT_TRUE(check(thick).is_solid());
  EXPECT_LT(thick.triangles.size(), shape.triangles.size());

  shape.points[14] = shape.points[13] + Vec3(1e-6, -1e-6, 0);
  shape.points[0] = Vec3(0, 0, 5);  // through the top
  EditedMesh broken = mesh();
  EXPECT_FALSE(thicken_doubles(broken, original, inexact, 1e-4, 0x1p-50));
  EXPECT_LT(broken.alive_faces().size(), shape.triangles.size()) << "thickened where it is sound";
}

TEST_F(Edit, knows_all_that_share_a_point) {
  const EditedMesh tube = mesh();
  for (std::uint32_t f = 0; f < tube.face_count(); ++f) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t g = 0; g < tube.face_count(); ++g) {
      const Triangle &s = shape.triangles[f], &t = shape.triangles[g];
      if (std::find_first_of(s.begin(), s.end(), t.begin(), t.end()) != s.end()) {
        expected.push_back(g);
      }
    }
    EXPECT_EQ(with_neighbours(tube, {f}), expected);
  }
}

}  // namespace
}  // namespace dupin::rounding
