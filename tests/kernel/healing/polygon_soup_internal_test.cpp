#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "healing/face_copies.h"
#include "healing/polygon_soup.h"
#include "kernel/healing/soups_internal.h"
#include "mesh/measure.h"
#include "support/shapes.h"

namespace dupin::healing {
namespace {

// Each face with points of its own, in any order.
TriMesh torn(const TriMesh& mesh, std::mt19937& random) {
  TriMesh result;
  std::vector<Triangle> triangles = mesh.triangles;
  std::shuffle(triangles.begin(), triangles.end(), random);
  for (const Triangle& t : triangles) {
    const auto first = static_cast<std::uint32_t>(result.points.size());
    for (const std::uint32_t corner : t) {
      result.points.push_back(mesh.points[corner]);
    }
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

// The number of faces that are turned in the end.
std::size_t orient(PolygonSoup& soup) {
  SettledCopies settled = settle_copies(soup);
  turn_shells_outward(soup, settled.is_paired, settled.is_turned);
  return static_cast<std::size_t>(std::ranges::count(settled.is_turned, 1));
}

int volume_sign(const PolygonSoup& soup) {
  return mesh::volume_sign({soup.points, soup.triangles});
}

TEST(PolygonSoup, merging_points_closes_what_was_torn) {
  std::mt19937 random(1);
  for (const TriMesh& mesh : {test::frame(), test::tube(1, 0, 2, 7)}) {
    const auto [soup, copies] = merge_duplicate_points(torn(mesh, random));
    EXPECT_EQ(copies, 3 * mesh.triangles.size() - mesh.points.size());
    EXPECT_TRUE(is_balanced(soup));
    EXPECT_EQ(soup.sources.size(), mesh.triangles.size());
  }
}

TEST(PolygonSoup, faces_are_turned_to_agree_and_shells_outward) {
  std::mt19937 random(7);
  const TriMesh mesh = test::joined({test::frame(), test::box({9, 9, 9}, {12, 12, 12}),
                                     test::reversed(test::box({10, 10, 10}, {11, 11, 11}))});
  for (int round = 0; round < 20; ++round) {
    TriMesh turned = mesh;
    std::size_t count = 0;
    for (Triangle& t : turned.triangles) {
      if (random() % 5 == 0) {
        std::swap(t[1], t[2]);
        ++count;
      }
    }
    PolygonSoup soup = soup_of(turned);
    const std::size_t turned_faces = orient(soup);
    EXPECT_TRUE(is_balanced(soup));
    // Most faces of each shell were right.
    EXPECT_EQ(soup.triangles, mesh.triangles) << round;
    EXPECT_EQ(turned_faces, count);
  }
}

TEST(PolygonSoup, a_shell_that_no_other_encloses_is_turned_outward_as_a_whole) {
  PolygonSoup soup = soup_of(test::reversed(test::frame()));
  ASSERT_EQ(volume_sign(soup), -1);
  EXPECT_EQ(orient(soup), soup.triangles.size());
  EXPECT_EQ(volume_sign(soup), 1);
}

}  // namespace
}  // namespace dupin::healing
