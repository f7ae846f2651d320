#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "checking/disjoint_face_groups.h"
#include "kernel/torus.h"
#include "mesh/coincident_points.h"
#include "predicates/triangle_overlap.h"
#include "support/none.h"
#include "support/shapes.h"

namespace dupin::checking {
namespace {

struct Welded {
  explicit Welded(const TriMesh& of)
      : mesh(of),
        representatives(mesh::coincident_representatives(of.points)),
        corners(of.triangles) {
    for (Triangle& t : corners) {
      for (std::uint32_t& corner : t) {
        corner = representatives[corner];
      }
    }
  }
  /// The very same triangles where no points are identical.
  [[nodiscard]] WeldedMesh view() const {
    const bool same = corners == mesh.triangles;
    return {mesh.points, mesh.triangles,
            same ? std::span<const Triangle>(mesh.triangles) : std::span<const Triangle>(corners),
            representatives};
  }
  const TriMesh& mesh;
  std::vector<std::uint32_t> representatives;
  std::vector<Triangle> corners;
};

bool share_injective_star(const DisjointFaceGroups& groups, const Triangle& s, const Triangle& t) {
  return std::ranges::any_of(s, [&](std::uint32_t v) {
    return groups.injective_stars[v] != 0 && std::ranges::find(t, v) != t.end();
  });
}

/// The pairs that the groups or stars settle, none of which may meet.
std::size_t settled_pairs(const Welded& welded, const DisjointFaceGroups& groups) {
  std::size_t settled = 0;
  const TriMesh& mesh = welded.mesh;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const predicates::TriangleOverlapTest test(mesh.points, welded.corners[f]);
    for (std::uint32_t g = f + 1; g < mesh.triangles.size(); ++g) {
      const bool of_one =
          groups.of_face[f] != support::kNone && groups.of_face[f] == groups.of_face[g];
      if (of_one || share_injective_star(groups, welded.corners[f], welded.corners[g])) {
        EXPECT_EQ(test.meeting(welded.corners[g]), predicates::TriangleOverlap::none)
            << f << " and " << g;
        ++settled;
      }
    }
  }
  return settled;
}

TEST(DisjointFaceGroups, hold_no_triangles_that_meet) {
  std::mt19937 random(1);
  std::size_t settled = 0;
  for (int round = 0; round < 12; ++round) {
    TriMesh mesh = test::torus(12, 24, 2, round % 3 == 0 ? 2.2 : 1);  // through itself, or not
    test::shake(mesh, 0.004 * (round % 4), random);
    const Welded welded(mesh);
    settled += settled_pairs(welded, proven_groups(welded.view(), true, 0));
  }
  EXPECT_GT(settled, 30000);
}

/// A low double pyramid over a regular polygon.
TriMesh bipyramid(std::uint32_t n) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0.25}, {0, 0, -0.25}};
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    mesh.points.emplace_back(std::cos(angle), std::sin(angle), 0);
    const std::uint32_t here = 2 + i, next = 2 + (i + 1) % n;
    mesh.triangles.push_back({0, here, next});
    mesh.triangles.push_back({1, next, here});
  }
  return mesh;
}

TEST(DisjointFaceGroups, are_made_of_large_stars_too) {
  const TriMesh mesh = bipyramid(100);
  const Welded welded(mesh);
  const std::vector<std::uint32_t> none(mesh.triangles.size(), support::kNone);
  const DisjointFaceGroups groups = given_groups(welded.view(), none);
  EXPECT_EQ(groups.injective_stars[0], 100);
  EXPECT_EQ(groups.injective_stars[1], 100);
  const std::set<std::uint32_t> numbers(groups.of_face.begin(), groups.of_face.end());
  EXPECT_EQ(numbers, (std::set<std::uint32_t>{0, 1}));
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    EXPECT_EQ(groups.of_face[f], groups.of_face[f % 2]);
  }
  settled_pairs(welded, groups);
}

TEST(DisjointFaceGroups, that_are_given_stay) {
  const TriMesh mesh = bipyramid(100);
  const Welded welded(mesh);
  std::vector<std::uint32_t> given(mesh.triangles.size(), support::kNone);
  for (std::uint32_t f = 0; f < given.size(); f += 2) {
    given[f] = 5;  // those of the upper pyramid
  }
  const DisjointFaceGroups groups = given_groups(welded.view(), given);
  for (std::uint32_t f = 0; f < given.size(); ++f) {
    EXPECT_EQ(groups.of_face[f], f % 2 == 0 ? 5 : 6) << "new numbers follow";
  }
  EXPECT_EQ(groups.injective_stars[0], 0) << "not sought where all have a group";
}

TEST(DisjointFaceGroups, are_not_made_of_stars_where_points_are_identical) {
  // A copy of the tip, with triangles of its own: contacts are to be told from neighbours.
  const TriMesh mesh = test::joined({bipyramid(100), test::tetrahedron(Vec3(0, 0, 0.25), 1)});
  const Welded welded(mesh);
  ASSERT_TRUE(welded.view().has_identical_points());
  const std::vector<std::uint32_t> none(mesh.triangles.size(), support::kNone);
  EXPECT_EQ(given_groups(welded.view(), none).of_face, none);
}

}  // namespace
}  // namespace dupin::checking
