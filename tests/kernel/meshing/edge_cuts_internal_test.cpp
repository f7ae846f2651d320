#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "meshing/edge_cuts.h"
#include "meshing/edge_edits.h"

namespace dupin::meshing {
namespace {

/// An octahedron in a sphere of radius 1, its triangles cut in four some times.
Tetrahedra sphere(int times) {
  Tetrahedra mesh;
  mesh.points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2},
                    {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
  for (int i = 0; i < times; ++i) {
    std::map<Edge, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, is_new] =
          middles.emplace(edge_of(a, b), static_cast<std::uint32_t>(mesh.points.size()));
      if (is_new) {
        mesh.points.push_back((mesh.points[a] + mesh.points[b]).normalized());
      }
      return at->second;
    };
    std::vector<Triangle> parts;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t p = middle(a, b), q = middle(b, c), r = middle(c, a);
      for (const Triangle& t :
           {Triangle{a, p, r}, Triangle{p, b, q}, Triangle{r, q, c}, Triangle{p, q, r}}) {
        parts.push_back(t);
      }
    }
    mesh.triangles = std::move(parts);
  }
  mesh.freedoms.assign(mesh.points.size(), Freedom::region);
  mesh.regions.assign(mesh.triangles.size(), 0);
  return mesh;
}

/// Of middles of edges and triangles, without some edges.
double largest_depth(const Tetrahedra& mesh, const std::set<Edge>& without) {
  double least = 1;
  for (const Triangle& t : mesh.triangles) {
    least =
        std::min(least, ((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3).norm());
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (!without.contains(edge_of(a, b))) {
        least = std::min(least, ((mesh.points[a] + mesh.points[b]) / 2).norm());
      }
    }
  }
  return 1 - least;
}

void expect_closed_and_outward(const Tetrahedra& mesh) {
  std::map<Edge, int> sides;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    EXPECT_GT((b - a).cross(c - a).dot(a + b + c), 0);
    for (std::size_t k = 0; k < 3; ++k) {
      ++sides[edge_of(t[k], t[(k + 1) % 3])];
    }
  }
  EXPECT_TRUE(std::ranges::all_of(sides, [](const auto& item) { return item.second == 2; }));
  EXPECT_EQ(mesh.points.size() + mesh.triangles.size(), sides.size() + 2);
  EXPECT_EQ(mesh.freedoms.size(), mesh.points.size());
  EXPECT_EQ(mesh.regions.size(), mesh.triangles.size());
}

TEST(EdgeCuts, bring_edges_across_a_bend_near_the_surface) {
  const Tetrahedra fine = sphere(5);
  const mesh::ReferenceSurface surface(fine.points, fine.triangles, fine.regions);
  Tetrahedra mesh = sphere(1);
  ASSERT_GT(largest_depth(mesh, {}), 0.07);
  EXPECT_TRUE(cut_far_edges(mesh, surface, {}, 0.05));
  expect_closed_and_outward(mesh);
  EXPECT_LT(largest_depth(mesh, {}), 0.052);  // the fine one is 0.002 below the sphere
  const std::size_t before = mesh.triangles.size();
  EXPECT_FALSE(cut_far_edges(mesh, surface, {}, 0.05)) << "nothing is far any more";
  EXPECT_EQ(mesh.triangles.size(), before);
}

TEST(EdgeCuts, leave_edges_of_chains) {
  const Tetrahedra fine = sphere(5);
  const mesh::ReferenceSurface surface(fine.points, fine.triangles, fine.regions);
  Tetrahedra mesh = sphere(1);
  const BorderChain chain = {{mesh.triangles[0][0], mesh.triangles[0][1]}, 2};
  const std::set<Edge> kept = edges_of(std::vector{chain});
  EXPECT_TRUE(cut_far_edges(mesh, surface, std::vector{chain}, 0.07));
  expect_closed_and_outward(mesh);
  EXPECT_LT(largest_depth(mesh, kept), 0.072);
  EXPECT_TRUE(std::ranges::any_of(mesh.triangles, [&](const Triangle& t) {
    return kept.contains(edge_of(t[0], t[1])) || kept.contains(edge_of(t[1], t[2])) ||
           kept.contains(edge_of(t[2], t[0]));
  }));
}

TEST(EdgeCuts, leave_edges_whose_halves_would_turn_triangles_over) {
  // A thin strip, folded to the other side by a surface that is far off to its side.
  const std::vector<Vec3> far = {{0, 10, 0}, {4, 10, 0}, {2, 10, 4}};
  const std::vector<Triangle> one = {{0, 1, 2}};
  const std::vector<std::uint32_t> regions = {0};
  const mesh::ReferenceSurface surface(far, one, regions);
  Tetrahedra mesh;
  mesh.points = {{0, 0, 0}, {20, 0, 0}, {10, 1, 0}, {10, -1, 0}};
  mesh.freedoms.assign(4, Freedom::region);
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  mesh.regions = {0, 0};
  const std::vector<BorderChain> rim = {{{0, 2, 1, 3, 0}, 1}};
  EXPECT_FALSE(cut_far_edges(mesh, surface, rim, 0.5));
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.points.size(), 4U);
}

}  // namespace
}  // namespace dupin::meshing
