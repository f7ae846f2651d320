#include <algorithm>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "gaps/boundary_loops.h"
#include "kernel/torus.h"
#include "support/shapes.h"

namespace dupin::gaps {
namespace {

using DirectedEdges = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

/// The edges of faces, less those run along the other way.
DirectedEdges open_edges(const TriMesh& mesh) {
  DirectedEdges surplus;
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      ++surplus[{t[k], t[(k + 1) % 3]}];
      --surplus[{t[(k + 1) % 3], t[k]}];
    }
  }
  std::erase_if(surplus, [](const auto& entry) { return entry.second <= 0; });
  return surplus;
}

TEST(BoundaryLoops, run_once_along_each_open_edge) {
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    TriMesh mesh = test::torus(8, 12, 2, 1);
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
    mesh.triangles.resize(mesh.triangles.size() - random() % 100);
    DirectedEdges left = open_edges(mesh);
    for (const BoundaryLoop& loop : boundary_loops(mesh)) {
      ASSERT_TRUE(loop.closed);
      double length = 0;
      for (std::size_t i = 0; i < loop.points.size(); ++i) {
        const std::uint32_t from = loop.points[i], to = loop.points[(i + 1) % loop.points.size()];
        ASSERT_EQ(left[std::pair(from, to)]--, 1);
        length += (mesh.points[from] - mesh.points[to]).norm();
      }
      EXPECT_NEAR(loop.length.lower, length, 1e-12);
      EXPECT_GE(loop.length.upper, loop.length.lower);
    }
    EXPECT_TRUE(std::ranges::all_of(left, [](const auto& entry) { return entry.second == 0; }));
  }
}

TEST(BoundaryLoops, are_measured_and_placed) {
  TriMesh mesh = test::box({0, 0, 0}, {3, 4, 5});
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2);  // the bottom
  const auto loops = boundary_loops(mesh);
  ASSERT_EQ(loops.size(), 1);
  EXPECT_EQ(loops[0].points, (std::vector<std::uint32_t>{0, 1, 3, 2}));
  EXPECT_EQ(loops[0].length, (Enclosure{14, 14}));
  EXPECT_EQ(loops[0].place, Vec3(1.5, 2, 0));
}

TEST(BoundaryLoops, run_twice_along_an_edge_whose_faces_disagree) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 2, 3}};  // both run from 1 to 2
  const auto loops = boundary_loops(mesh);
  std::size_t edges = 0, shared = 0;
  for (const BoundaryLoop& loop : loops) {
    EXPECT_TRUE(loop.closed);
    edges += loop.points.size();
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      shared += loop.points[i] == 1 && loop.points[(i + 1) % loop.points.size()] == 2 ? 1 : 0;
    }
  }
  EXPECT_EQ(edges, 6);
  EXPECT_EQ(shared, 2);
}

TEST(BoundaryLoops, take_identical_points_for_one) {
  TriMesh mesh = test::box(Vec3::Constant(0), Vec3::Constant(1));
  EXPECT_TRUE(boundary_loops(mesh).empty());
  TriMesh apart;  // each face with points of its own
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(apart.points.size());
    for (const std::uint32_t corner : t) {
      apart.points.push_back(mesh.points[corner]);
    }
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_TRUE(boundary_loops(apart).empty());
}

}  // namespace
}  // namespace dupin::gaps
