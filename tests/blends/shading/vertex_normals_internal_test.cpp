#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "shading/vertex_normals.h"

namespace dupin::shading {
namespace {

constexpr MeshBounds kBounds{0.01, 0.01, 0.25};

Vec3 vec(const Direction& d) { return {double(d[0]), double(d[1]), double(d[2])}; }

// Two triangles that share the edge from point 0 to point 1, folded there.
TriMesh folded(double height) {
  return {{{0, 0, 0}, {0, 1, 0}, {1, 0, height}, {-1, 0, height}},
          {{0, 2, 1}, {0, 1, 3}},
          {0, 1},
          {"right", "left"}};
}

// The planes of both, leaning by this angle each.
PatchTable planes(double angle) {
  const Vec3 right(-std::sin(angle), 0, std::cos(angle)), left(std::sin(angle), 0, std::cos(angle));
  return {{FlatPatch{{0, 0, 0}, right}, FlatPatch{{0, 0, 0}, left}},
          {{"right", {0}}, {"left", {1}}},
          {}};
}

TEST(VertexNormals, are_the_surfaces_own_on_both_sides_of_a_crease) {
  const CornerNormals normals = vertex_normals(planes(0.1), folded(std::tan(0.1)), kBounds);
  ASSERT_EQ(normals.size(), 2);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LT((vec(normals[0].at(k)) - Vec3(-std::sin(0.1), 0, std::cos(0.1))).norm(), 1e-7);
    EXPECT_LT((vec(normals[1].at(k)) - Vec3(std::sin(0.1), 0, std::cos(0.1))).norm(), 1e-7);
  }
}

// Neighbours that turn by less than a degree share the mean; others do not.
TEST(VertexNormals, of_tangent_neighbours_are_one) {
  const double angle = 0.4 * std::numbers::pi / 180;
  PatchTable table = planes(angle);
  const TriMesh mesh = folded(std::tan(angle));
  EXPECT_NE(vertex_normals(table, mesh, kBounds)[0][0], vertex_normals(table, mesh, kBounds)[1][0]);
  table.neighbours.emplace(0, 1);
  const CornerNormals normals = vertex_normals(table, mesh, kBounds);
  EXPECT_EQ(normals[0][0], (Direction{0, 0, 1}));
  EXPECT_EQ(normals[0][0], normals[1][0]);
  EXPECT_EQ(normals[0][2], normals[1][1]);
  EXPECT_NE(normals[0][1], normals[1][2]);  // not at the other corners
  PatchTable steeper = planes(2 * angle);
  steeper.neighbours.emplace(0, 1);
  const CornerNormals apart = vertex_normals(steeper, folded(std::tan(2 * angle)), kBounds);
  EXPECT_NE(apart[0][0], apart[1][0]);
}

TEST(VertexNormals, point_to_the_side_of_the_triangles) {
  PatchTable table = planes(0);
  std::get<FlatPatch>(table.patches[0]).normal = -Vec3::UnitZ();
  const CornerNormals normals = vertex_normals(table, folded(0), kBounds);
  EXPECT_EQ(normals[0][0], (Direction{0, 0, 1}));
  EXPECT_EQ(normals[1][0], normals[0][0]);
}

TEST(VertexNormals, are_the_triangles_own_where_no_surface_is_known_or_near) {
  const double angle = 0.3;
  const TriMesh mesh = folded(std::tan(angle));
  const Vec3 facet(-std::sin(angle), 0, std::cos(angle));
  const auto expect_facets = [&](const PatchTable& table, const TriMesh& of, const char* why) {
    const CornerNormals normals = vertex_normals(table, of, kBounds);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LT((vec(normals[0].at(k)) - facet).norm(), 1e-7) << why;
    }
  };
  TriMesh unlabelled = mesh;
  unlabelled.labels.clear();
  expect_facets(planes(0), unlabelled, "no labels");
  TriMesh stranger = mesh;
  stranger.names[0] = "stranger";
  expect_facets(planes(0), stranger, "no patch");
  PatchTable away = planes(0);
  std::get<FlatPatch>(away.patches[0]).point = Vec3(0, 0, -1);
  expect_facets(away, mesh, "far away");
  PatchTable steep = planes(0);
  std::get<FlatPatch>(steep.patches[0]).normal = Vec3::UnitY();  // through points 0 and 2
  EXPECT_LT((vec(vertex_normals(steep, mesh, kBounds)[0][0]) - facet).norm(), 1e-7) << "steep";
}

// The nearest of several patches of a name is a triangle's.
TEST(VertexNormals, are_those_of_the_patch_that_the_triangle_lies_on) {
  PatchTable table = planes(0.2);
  table.of_name = {{"both", {0, 1}}};
  TriMesh mesh = folded(std::tan(0.2));
  mesh.labels = {0, 0};
  mesh.names = {"both"};
  const CornerNormals normals = vertex_normals(table, mesh, kBounds);
  EXPECT_LT((vec(normals[0][0]) - Vec3(-std::sin(0.2), 0, std::cos(0.2))).norm(), 1e-7);
  EXPECT_LT((vec(normals[1][0]) - Vec3(std::sin(0.2), 0, std::cos(0.2))).norm(), 1e-7);
}

}  // namespace
}  // namespace dupin::shading
