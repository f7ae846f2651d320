#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "healing/degenerate_faces.h"
#include "kernel/healing/soups_internal.h"
#include "mesh/measure.h"
#include "support/shapes.h"

namespace dupin::healing {
namespace {

TEST(DegenerateFaces, faces_without_area_go_and_leave_no_slit) {
  // The top of the box meets the rest at a point in the middle of an edge, bridged by a cap.
  TriMesh mesh = test::box({0, 0, 0}, {2, 2, 2});
  const auto middle = static_cast<std::uint32_t>(mesh.points.size());
  const Triangle whole = mesh.triangles.back();
  mesh.points.push_back((mesh.points[whole[0]] + mesh.points[whole[1]]) / 2);
  mesh.triangles.back() = {whole[0], middle, whole[2]};
  mesh.triangles.push_back({middle, whole[1], whole[2]});
  mesh.triangles.push_back({whole[1], middle, whole[0]});  // without area
  mesh.triangles.push_back({whole[1], whole[1], whole[0]});
  PolygonSoup soup = soup_of(mesh);
  EXPECT_EQ(drop_degenerate_faces(soup), 2U);
  EXPECT_TRUE(is_balanced(soup));
  EXPECT_EQ(soup.triangles.size(), 14U);
  EXPECT_EQ(mesh::exact_volume({soup.points, soup.triangles}), 8);
  for (const Triangle& t : soup.triangles) {
    const Vec3 a = soup.points[t[0]];
    EXPECT_FALSE((soup.points[t[1]] - a).cross(soup.points[t[2]] - a).isZero(0));
  }
}

// Any edges of a face divided, all of its copies alike, whichever way round.
TEST(DegenerateFaces, copies_of_a_face_fall_into_the_same) {
  for (unsigned edges = 1; edges < 8; ++edges) {
    PolygonSoup soup{{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}},
                     {{0, 1, 2}, {2, 1, 0}, {1, 2, 0}, {0, 2, 1}},
                     {0, 1, 2, 3}};
    for (std::uint32_t k = 0; k < 3; ++k) {
      for (std::uint32_t i = 1; (edges >> k & 1U) != 0 && i < 1 + k + edges % 3; ++i) {
        const std::uint32_t from = k, to = (k + 1) % 3;
        soup.points.emplace_back(soup.points[from] + (soup.points[to] - soup.points[from]) * i / 8);
        soup.triangles.push_back({from, to, static_cast<std::uint32_t>(soup.points.size() - 1)});
        soup.sources.push_back(9);
      }
    }
    drop_degenerate_faces(soup);
    std::map<Triangle, int> copies;
    for (Triangle t : soup.triangles) {
      const Vec3 a = soup.points[t[0]];
      EXPECT_FALSE((soup.points[t[1]] - a).cross(soup.points[t[2]] - a).isZero(0));
      std::ranges::sort(t);
      ++copies[t];
    }
    EXPECT_TRUE(std::ranges::all_of(copies, [](const auto& c) { return c.second == 4; }));
    EXPECT_TRUE(is_balanced(soup));
  }
}

}  // namespace
}  // namespace dupin::healing
