#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meshing/features.h"
#include "support/shapes.h"

namespace dupin::meshing {
namespace {

using dupin::test::box;
using dupin::test::tube;

/// A box with a wedge on top that has a label of its own. Its tip is point 11; points 10 and 12 are
/// near it, one on each side.
TriMesh box_with_wedge() {
  TriMesh mesh;
  for (const double z : {-1.0, 0.0}) {
    for (const Vec3& corner : {Vec3(-3, -3, z), Vec3(3, -3, z), Vec3(3, 3, z), Vec3(-3, 3, z)}) {
      mesh.points.push_back(corner);
    }
  }
  for (const Vec3& point : {Vec3(1.5, -0.6, 0), Vec3(1.5, 0.1, 0), Vec3(-1.4, 0.35, 0),
                            Vec3(-2, 0, 0), Vec3(-1.6, -0.07, 0)}) {
    mesh.points.push_back(point);
  }
  mesh.triangles = {{11, 12, 10}, {12, 8, 9}, {12, 9, 10},  // the wedge
                    {4, 5, 12},   {5, 8, 12}, {5, 6, 8},   {6, 9, 8},   {6, 7, 9},
                    {7, 11, 10},  {7, 10, 9}, {7, 4, 11},  {4, 12, 11},  // around it
                    {0, 2, 1},    {0, 3, 2}};
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t next = (k + 1) % 4;
    mesh.triangles.push_back({k, next, next + 4});
    mesh.triangles.push_back({k, next + 4, k + 4});
  }
  mesh.labels.assign(mesh.triangles.size(), 0);
  std::fill_n(mesh.labels.begin(), 3, 1);
  mesh.names = {"box", "wedge"};
  return mesh;
}

TEST(Features, of_a_box_are_its_edges) {
  const Features features = find_features(box(Vec3::Zero(), Vec3(1, 2, 3)), 0.7, 0.01, 0);
  EXPECT_EQ(features.curves.size(), 12U);
  EXPECT_EQ(*std::ranges::max_element(features.regions), 5U);
  for (const Curve& curve : features.curves) {
    EXPECT_EQ(curve.points.size(), 2U);
    EXPECT_NE(curve.regions[0], curve.regions[1]);
  }
}

// However large the angle of sharp edges is: in one region with both sides, the plate's edges would
// all be as short as it is thick.
TEST(Features, of_a_plate_are_its_rims) {
  for (const double thickness : {1.0, 0.1}) {
    const TriMesh plate = box(Vec3::Zero(), Vec3(100, 100, thickness));
    EXPECT_EQ(find_features(plate, 1.6, 0.1, 14).curves.size(), 12U) << thickness;
  }
  const TriMesh cube = box(Vec3::Zero(), Vec3(100, 100, 100));
  EXPECT_EQ(find_features(cube, 1.6, 0.1, 1).curves.size(), 0U) << "no edge is longer than 1";
}

TEST(Features, of_a_tube_are_two_loops) {
  const Features features = find_features(tube(1, 0, 4, 64), 0.7, 0.01, 0);
  ASSERT_EQ(features.curves.size(), 2U);
  for (const Curve& curve : features.curves) {
    ASSERT_EQ(curve.points.size(), 65U);
    EXPECT_EQ(curve.points.front(), curve.points.back());
    EXPECT_NE(curve.regions[0], curve.regions[1]);
  }
  EXPECT_EQ(*std::ranges::max_element(features.regions), 2U);
}

TEST(Features, are_creases_that_would_need_tiny_triangles) {
  // Ten sides turn by 0.63 each: triangles as wide as they are miss an edge between by 0.05.
  const TriMesh prism = tube(1, 0, 4, 10);
  EXPECT_EQ(find_features(prism, 0.7, 0.01, 1).curves.size(), 30U);
  EXPECT_EQ(find_features(prism, 0.7, 0.02, 1).curves.size(), 2U);
  EXPECT_EQ(find_features(prism, 0.7, 0.01, 0.1).curves.size(), 2U) << "these are smaller anyway";
}

TEST(Features, end_where_a_border_goes_back_at_a_sharp_angle) {
  // Across the wedge, its sides are nearer to each other than the distance: from there the border
  // seems to turn by more than at the tip.
  const TriMesh mesh = box_with_wedge();
  const Features features = find_features(mesh, 0.7, 0.3, 2);
  EXPECT_TRUE(std::ranges::any_of(features.curves, [&](const Curve& curve) {
    return curve.points.front() == mesh.points[11] || curve.points.back() == mesh.points[11];
  }));
}

TEST(Features, are_borders_between_labels_too) {
  TriMesh mesh = tube(1, 0, 4, 64);
  EXPECT_TRUE(find_features(mesh, 3, 0.01, 0).curves.empty());
  mesh.names = {"wall", "end"};
  for (const Triangle& t : mesh.triangles) {
    const bool is_end = mesh.points[t[0]].z() == mesh.points[t[1]].z() &&
                        mesh.points[t[0]].z() == mesh.points[t[2]].z();
    mesh.labels.push_back(is_end ? 1 : 0);
  }
  EXPECT_EQ(find_features(mesh, 3, 0.01, 0).curves.size(), 2U);
}

TEST(Features, have_corners_where_curves_turn_sharply) {
  // The sides of a box in one label, its top and bottom in others: two borders of four edges.
  TriMesh mesh = box(Vec3::Zero(), Vec3(1, 1, 1));
  mesh.names = {"sides", "top", "bottom"};
  for (const Triangle& t : mesh.triangles) {
    const auto all_at = [&](double z) {
      return std::ranges::all_of(t, [&](std::uint32_t v) { return mesh.points[v].z() == z; });
    };
    mesh.labels.push_back(all_at(1) ? 1 : all_at(0) ? 2 : 0);
  }
  const Features features = find_features(mesh, 3, 0.01, 0);
  std::size_t edges = 0;
  for (const Curve& curve : features.curves) {
    edges += curve.points.size() - 1;
    for (std::size_t i = 1; i + 1 < curve.points.size(); ++i) {
      ADD_FAILURE() << "a curve goes around a corner";
    }
  }
  EXPECT_EQ(edges, 8U);
}

TEST(Features, normals_of_triangles_without_height_are_those_beside_them) {
  // A point beside the diagonal of the bottom, as far as rounding puts it.
  TriMesh mesh = box(Vec3::Zero(), Vec3(1, 1, 1));
  const auto middle = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.emplace_back(0.5, 0.5 + 0x1p-53, 0);
  const Triangle first = mesh.triangles[0];
  mesh.triangles[0] = {first[0], first[1], middle};
  mesh.triangles.push_back({first[1], first[2], middle});
  mesh.triangles.push_back({first[2], first[0], middle});
  const Features features = find_features(mesh, 0.7, 0.01, 0);
  for (const std::size_t f :
       {std::size_t{0}, mesh.triangles.size() - 2, mesh.triangles.size() - 1}) {
    EXPECT_NEAR(features.normals[f].dot(Vec3(0, 0, -1)), 1, 1e-9);
  }
  EXPECT_EQ(features.curves.size(), 12U);
}

TEST(Features, thin_regions_become_part_of_their_neighbours) {
  // One narrow triangle of an end has a label of its own.
  TriMesh mesh = tube(1, 0, 4, 32);
  mesh.names = {"tube", "sliver"};
  mesh.labels.assign(mesh.triangles.size(), 0);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    const double area =
        (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm();
    if (area < 0.1 && area > 0) {
      mesh.labels[f] = 1;
      break;
    }
  }
  const Features fine = find_features(mesh, 0.7, 1e-6, 0);
  EXPECT_EQ(*std::ranges::max_element(fine.regions), 3U);
  const Features coarse = find_features(mesh, 0.7, 1, 0);
  EXPECT_EQ(*std::ranges::max_element(coarse.regions), 2U);
  EXPECT_GT(coarse.absorbed, 0);
  EXPECT_LE(coarse.absorbed, 0.25);
}

}  // namespace
}  // namespace dupin::meshing
