#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "kernel/meshing/plane_internal.h"
#include "meshing/edge_edits.h"
#include "meshing/patch_trials.h"

namespace dupin::meshing {
namespace {

/// The last points may move.
Tetrahedra mesh_of(const std::vector<std::array<double, 2>>& places,
                   std::vector<Triangle> triangles, std::size_t free) {
  Tetrahedra mesh;
  for (const auto& [x, y] : places) {
    mesh.points.emplace_back(x, y, 0);
  }
  mesh.freedoms.assign(places.size() - free, Freedom::none);
  mesh.freedoms.resize(places.size(), Freedom::region);
  mesh.triangles = std::move(triangles);
  mesh.regions.assign(mesh.triangles.size(), 0);
  return mesh;
}

/// Of all angles, and of those that are not between two edges of the rim.
std::pair<double, double> smallest(const Tetrahedra& mesh, const BorderChain& rim) {
  const std::set<Edge> curves = edges_of(std::vector{rim});
  double all = M_PI, others = M_PI;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      const Vec3 u = mesh.points[b] - mesh.points[a], v = mesh.points[c] - mesh.points[a];
      const double angle = std::acos(u.normalized().dot(v.normalized()));
      all = std::min(all, angle);
      if (!curves.contains(edge_of(a, b)) || !curves.contains(edge_of(a, c))) {
        others = std::min(others, angle);
      }
    }
  }
  return {all, others};
}

/// The rim is there once, other edges twice, and the area is as before.
void expect_fills(const Tetrahedra& mesh, const BorderChain& rim, const Tetrahedra& before) {
  std::map<Edge, int> sides;
  const auto area_of = [](const Tetrahedra& given) {
    double area = 0;
    for (const auto& [a, b, c] : given.triangles) {
      area += (given.points[b] - given.points[a]).cross(given.points[c] - given.points[a]).z() / 2;
    }
    return area;
  };
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++sides[edge_of(t[k], t[(k + 1) % 3])];
    }
  }
  const std::set<Edge> border = edges_of(std::vector{rim});
  for (const auto& [edge, count] : sides) {
    EXPECT_EQ(count, border.contains(edge) ? 1 : 2) << edge.first << " " << edge.second;
  }
  EXPECT_NEAR(area_of(mesh), area_of(before), 1e-12);
  EXPECT_EQ(mesh.freedoms.size(), mesh.points.size());
  EXPECT_EQ(mesh.regions.size(), mesh.triangles.size());
}

/// Two points in a wedge of 22 degrees, as refinement leaves them; one alone is not drawn away.
struct Wedge {
  BorderChain rim = {{0, 1, 2, 3, 4, 0}, 1};
  Tetrahedra mesh =
      mesh_of({{-0.0165, -0.3301},
               {0.056, 0.1872},
               {0.0757, 0.3272},
               {-0.1724, 0.3161},
               {-0.139, 0.1776},
               {-0.0395, 0.1429},
               {-0.0417, 0.1905}},
              {{0, 5, 4}, {0, 1, 5}, {6, 4, 5}, {3, 4, 6}, {6, 2, 3}, {1, 2, 6}, {1, 6, 5}}, 2);
};

TEST(PatchTrials, empty_a_wedge_that_two_points_cut) {
  const Plane plane;
  Wedge wedge;
  const Tetrahedra before = wedge.mesh;
  ASSERT_FALSE(
      edit_edges(wedge.mesh, plane.surface, std::vector{wedge.rim}, 25 * kDegree, kLimits));
  ASSERT_LT(smallest(before, wedge.rim).second, 11 * kDegree);
  EXPECT_TRUE(
      try_patches(wedge.mesh, plane.surface, std::vector{wedge.rim}, 25 * kDegree, kLimits));
  expect_fills(wedge.mesh, wedge.rim, before);
  EXPECT_GT(smallest(wedge.mesh, wedge.rim).first, 21 * kDegree);
  EXPECT_GE(smallest(wedge.mesh, wedge.rim).second, 25 * kDegree);
}

TEST(PatchTrials, put_points_where_a_border_gets_finer) {
  // Beside a border whose edges are a fifth as long from one of its points on.
  const Plane plane;
  const BorderChain rim = {{0, 1, 2, 3, 4, 5, 6, 7, 8, 0}, 1};
  Tetrahedra mesh = mesh_of({{-0.3215, -0.9685},
                             {-0.1454, -0.0290},
                             {-0.1111, 0.1540},
                             {-0.0699, 0.3734},
                             {0.0122, 0.6241},
                             {0.2625, 0.8897},
                             {0.6425, 1.2931},
                             {1.5820, 0.4905},
                             {1.0535, -0.3021},
                             {0.2565, -0.1250},
                             {0.3611, 0.3265}},
                            {{10, 8, 9},
                             {0, 1, 9},
                             {5, 6, 10},
                             {10, 4, 5},
                             {7, 8, 10},
                             {1, 2, 9},
                             {10, 2, 3},
                             {2, 10, 9},
                             {8, 0, 9},
                             {6, 7, 10},
                             {3, 4, 10}},
                            2);
  const Tetrahedra before = mesh;
  improve_angles(mesh, plane.surface, 25 * kDegree, kLimits);
  edit_edges(mesh, plane.surface, std::vector{rim}, 25 * kDegree, kLimits);
  ASSERT_LT(smallest(mesh, rim).second, 24.5 * kDegree);
  EXPECT_TRUE(try_patches(mesh, plane.surface, std::vector{rim}, 25 * kDegree, kLimits));
  expect_fills(mesh, rim, before);
  EXPECT_GE(smallest(mesh, rim).second, 25 * kDegree);
}

TEST(PatchTrials, leave_what_is_good_and_what_lies_between_two_edges) {
  const Plane plane;
  const Wedge wedge;
  Tetrahedra between = mesh_of({{0, 0}, {1, -0.15}, {1, 0.15}}, {{0, 1, 2}}, 0);
  const std::vector<BorderChain> rim = {{{0, 1, 2, 0}, 1}};
  EXPECT_FALSE(try_patches(between, plane.surface, rim, 25 * kDegree, kLimits));
  Tetrahedra good = wedge.mesh;
  EXPECT_FALSE(try_patches(good, plane.surface, std::vector{wedge.rim}, 5 * kDegree, kLimits));
  EXPECT_EQ(good.points, wedge.mesh.points);
  EXPECT_EQ(good.triangles, wedge.mesh.triangles);
}

TEST(PatchTrials, leave_what_would_be_far_from_the_surface) {
  // The plane is below the mesh, by more than is allowed.
  Plane plane;
  for (Vec3& point : plane.points) {
    point.z() = -1;
  }
  Wedge wedge;
  EXPECT_FALSE(
      try_patches(wedge.mesh, plane.surface, std::vector{wedge.rim}, 25 * kDegree, kLimits));
}

}  // namespace
}  // namespace dupin::meshing
