#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "formats/same_mesh.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

TriMesh labelled() {
  TriMesh mesh = test::tetrahedron();
  mesh.names = {"a", "b"};
  mesh.labels = {0, 1, 0, 1};
  return mesh;
}

TEST(SameMesh, may_number_its_points_otherwise) {
  const TriMesh mesh = test::tetrahedron();
  EXPECT_FALSE(formats::first_difference(mesh, mesh));
  TriMesh other = mesh;
  other.points = {mesh.points[2], Vec3(9, 9, 9), mesh.points[3], mesh.points[0], mesh.points[1]};
  for (Triangle& t : other.triangles) {
    for (std::uint32_t& corner : t) {
      corner = std::array<std::uint32_t, 4>{3, 4, 0, 2}[corner];
    }
  }
  EXPECT_FALSE(formats::first_difference(mesh, other));
}

TEST(SameMesh, may_list_its_triangles_label_by_label) {
  const TriMesh mesh = labelled();
  TriMesh other = mesh;
  other.triangles = {mesh.triangles[0], mesh.triangles[2], mesh.triangles[1], mesh.triangles[3]};
  EXPECT_FALSE(formats::first_difference(mesh, other));
  EXPECT_TRUE(formats::first_difference(test::tetrahedron(), other))
      << "without labels there is one order";
}

TEST(SameMesh, differs_by_a_number) {
  TriMesh other = test::tetrahedron();
  const std::uint32_t last = other.triangles[3][0];
  other.points[last].x() = std::nextafter(other.points[last].x(), 10);
  EXPECT_EQ(formats::first_difference(test::tetrahedron(), other), [&] {
    std::uint32_t face = 0;
    while (std::ranges::find(other.triangles[face], last) == other.triangles[face].end()) {
      ++face;
    }
    return face;
  }());
}

TEST(SameMesh, differs_by_points_that_became_one_or_two) {
  TriMesh apart = test::tetrahedron(), welded = apart;
  const auto count = static_cast<std::uint32_t>(apart.points.size());
  for (const Triangle& t : welded.triangles) {
    apart.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  }
  apart.points.insert(apart.points.end(), welded.points.begin(), welded.points.end());
  welded.triangles.insert(welded.triangles.end(), welded.triangles.begin(),
                          welded.triangles.begin() + 4);
  EXPECT_EQ(formats::first_difference(apart, welded), 4);
  EXPECT_EQ(formats::first_difference(welded, apart), 4);
}

TEST(SameMesh, differs_by_missing_further_and_turned_triangles) {
  const TriMesh mesh = test::tetrahedron();
  TriMesh fewer = mesh, turned = mesh;
  fewer.triangles.pop_back();
  EXPECT_EQ(formats::first_difference(mesh, fewer), 3);
  EXPECT_EQ(formats::first_difference(fewer, mesh), 2) << "the last one that is there";
  EXPECT_EQ(formats::first_difference({}, mesh), 0);
  std::swap(turned.triangles[2][0], turned.triangles[2][1]);
  EXPECT_EQ(formats::first_difference(mesh, turned), 2);
}

}  // namespace
}  // namespace dupin
