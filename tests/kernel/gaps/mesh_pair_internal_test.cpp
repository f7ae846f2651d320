#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "gaps/mesh_pair.h"
#include "predicates/triangle_distance.h"
#include "support/shapes.h"

namespace dupin::gaps {
namespace {

TEST(MeshPair, has_one_index_for_identical_points) {
  const TriMesh a = test::box({0, 0, 0}, {1, 1, 1}), b = test::box({1, 0, 0}, {2, 1, 1});
  const MeshPair pair = merged(a, b);
  ASSERT_EQ(pair.faces_of_a, 12);
  ASSERT_EQ(pair.triangles.size(), 24);
  std::set<std::uint32_t> of_a, of_b;
  for (const Triangle& t : pair.of_a()) {
    of_a.insert(t.begin(), t.end());
  }
  for (const Triangle& t : pair.of_b()) {
    of_b.insert(t.begin(), t.end());
  }
  std::vector<std::uint32_t> common;
  std::ranges::set_intersection(of_a, of_b, std::back_inserter(common));
  EXPECT_EQ(common, (std::vector<std::uint32_t>{1, 3, 5, 7})) << "the corners at x = 1 of a";
  for (std::uint32_t f = 0; f < 24; ++f) {
    const TriMesh& own = pair.in_a(f) ? a : b;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(pair.corners(f)[k], own.points[own.triangles[pair.source[f]][k]]);
    }
  }
}

TEST(MeshPair, counts_faces_without_area) {
  TriMesh a = test::tetrahedron();
  a.points.emplace_back(0.5, 0, 0);
  a.points.emplace_back(1, 0, 0);                                   // point 1 once more
  a.triangles.insert(a.triangles.begin(), {{0, 1, 4}, {1, 5, 2}});  // on a line; repeats a corner
  const MeshPair pair = merged(a, test::tetrahedron({5, 5, 5}));
  EXPECT_EQ(pair.flat_faces, 2);
  EXPECT_EQ(pair.faces_of_a, 5);
  EXPECT_EQ(pair.flat[0], 1);
  EXPECT_EQ(pair.source[1], 2);
}

TEST(MeshPair, refuses_what_is_no_mesh) {
  TriMesh bad = test::tetrahedron();
  bad.points[2].y() = NAN;
  EXPECT_THROW(merged(bad, {}), Error);
  TriMesh worse = test::tetrahedron();
  worse.triangles[0][0] = 9;
  EXPECT_THROW(merged({}, worse), Error);
}

predicates::ExactTriangle exact(const MeshPair& pair, std::uint32_t face) {
  predicates::ExactTriangle corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = exact::exact_vector(pair.corners(face)[k]);
  }
  return corners;
}

TriMesh soup(std::size_t count, std::mt19937& random) {
  std::uniform_real_distribution<double> place(0, 10), size(-1, 1);
  TriMesh mesh;
  for (std::uint32_t f = 0; f < count; ++f) {
    const Vec3 at(place(random), place(random), place(random));
    for (int k = 0; k < 3; ++k) {
      mesh.points.push_back(at + Vec3(size(random), size(random), size(random)));
    }
    mesh.triangles.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  return mesh;
}

TEST(FaceBoxIndex, visits_all_faces_within_the_reach) {
  std::mt19937 random(4);
  const MeshPair pair = merged(soup(30, random), soup(60, random));
  const FaceBoxIndex index(pair);
  std::size_t within = 0, visits = 0;
  for (const double reach : {0.0, 0.5, 3.0, 100.0}) {
    for (std::uint32_t a = 0; a < pair.faces_of_a; ++a) {
      std::set<std::uint32_t> visited;
      index.visit_near(a, reach, [&](std::uint32_t b) {
        EXPECT_FALSE(pair.in_a(b));
        EXPECT_TRUE(visited.insert(b).second) << "once";
      });
      visits += visited.size();
      const predicates::Fraction limit{CGAL::Mpzf(reach) * CGAL::Mpzf(reach), 1};
      for (std::uint32_t b = pair.faces_of_a; b < pair.triangles.size(); ++b) {
        if (!(limit < predicates::squared_distance(exact(pair, a), exact(pair, b)))) {
          ASSERT_TRUE(visited.contains(b)) << reach;
          ++within;
        }
      }
    }
  }
  EXPECT_GT(within, 1800) << "all, at least, where the reach is above all distances";
  EXPECT_LT(visits, 4 * 1800);
}

}  // namespace
}  // namespace dupin::gaps
