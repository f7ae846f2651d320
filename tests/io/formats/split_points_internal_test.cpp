#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "formats/split_points.h"
#include "io/formats/creased.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

TEST(SplitPoints, copies_points_once_for_each_further_normal) {
  const TriMesh mesh = test::tetrahedron();
  const CornerNormals normals = test::creased_normals();
  const formats::SplitPoints split = formats::split_points(mesh, normals);
  EXPECT_EQ(split.copied.size(), test::kCreasedCopies);
  ASSERT_EQ(split.normals.size(), mesh.points.size() + split.copied.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = split.triangles[i].at(k), point = mesh.triangles[i].at(k);
      EXPECT_EQ(split.normals[vertex], normals[i].at(k));
      EXPECT_EQ(vertex < 4 ? vertex : split.copied[vertex - 4], point);
    }
  }
}

TEST(SplitPoints, copies_nothing_of_a_smooth_mesh) {
  const TriMesh mesh = test::tetrahedron();
  const formats::SplitPoints split =
      formats::split_points(mesh, CornerNormals(4, {Direction{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}));
  EXPECT_TRUE(split.copied.empty());
  EXPECT_EQ(split.triangles, mesh.triangles);
}

TEST(SplitPoints, gives_points_without_triangles_a_normal_too) {
  TriMesh mesh = test::tetrahedron();
  mesh.points.emplace_back(7, 7, 7);
  EXPECT_EQ(formats::split_points(mesh, test::creased_normals()).normals[4], (Direction{0, 0, 1}));
}

TEST(SplitPoints, has_the_normals_that_are_given) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const Direction up{0, 0, 1}, aside{1, 0, 0};
  const formats::SplitPoints split =
      formats::split_points(mesh, {{up, up, up}}, {{0, up}, {1, aside}});
  EXPECT_EQ(split.triangles, (std::vector<Triangle>{{0, 3, 2}}));
  EXPECT_EQ(split.copied, std::vector<std::uint32_t>{1});
  EXPECT_EQ(split.normals, (std::vector<Direction>{up, aside, up, up}));
}

TEST(SplitPoints, refuses_normals_that_do_not_fit) {
  const auto refusal = [](const CornerNormals& normals) -> std::string {
    try {
      (void)formats::split_points(test::tetrahedron(), normals);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
      return error.what();
    }
    return "accepted";
  };
  CornerNormals normals = test::creased_normals();
  normals[2][1][0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusal(normals), "a normal of triangle 2 is not finite");
  normals.pop_back();
  EXPECT_EQ(refusal(normals), "there are normals of 3 triangles, not of 4");
}

TEST(SplitPoints, are_merged_again) {
  const TriMesh mesh = test::tetrahedron();
  const formats::SplitPoints split = formats::split_points(mesh, test::creased_normals());
  TriMesh vertices = mesh;
  vertices.triangles = split.triangles;
  for (const std::uint32_t point : split.copied) {
    vertices.points.push_back(mesh.points[point]);
  }
  TriMesh merged = vertices;
  EXPECT_TRUE(formats::merge_copies(split.copied, merged));
  EXPECT_TRUE(test::identical(merged, mesh));
  TriMesh moved = vertices;
  moved.points.back().x() += 1;
  EXPECT_FALSE(formats::merge_copies(split.copied, moved));
  std::vector<std::uint32_t> wrong = split.copied;
  wrong.back() = 4;  // a copy itself
  EXPECT_FALSE(formats::merge_copies(wrong, vertices));
  EXPECT_FALSE(formats::merge_copies(std::vector<std::uint32_t>(99, 0), vertices));
}

}  // namespace
}  // namespace dupin
