#include <cmath>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "healing/face_copies.h"
#include "kernel/healing/soups_internal.h"
#include "support/shapes.h"

namespace dupin::healing {
namespace {

TEST(FaceCopies, of_copies_of_faces_one_stays) {
  TriMesh mesh = test::frame();
  const Triangle t = mesh.triangles[5];
  mesh.triangles.push_back({t[1], t[2], t[0]});
  mesh.triangles.push_back(t);
  PolygonSoup soup = soup_of(mesh);
  EXPECT_EQ(settle_copies(soup).dropped, 2U);
  EXPECT_TRUE(is_balanced(soup));
}

TEST(FaceCopies, of_faces_that_cover_both_ways_none_stays_unless_needed) {
  // A wall within a closed surface, run both ways, is of no use.
  TriMesh wall = test::box({0, 0, 0}, {1, 1, 1});
  wall.triangles.push_back({0, 3, 7});
  wall.triangles.push_back({0, 7, 3});
  PolygonSoup soup = soup_of(wall);
  EXPECT_EQ(settle_copies(soup).dropped, 2U);
  EXPECT_EQ(soup.triangles, test::box({0, 0, 0}, {1, 1, 1}).triangles);
  // A face of the surface itself is.
  TriMesh doubled = test::tetrahedron();
  const Triangle t = doubled.triangles[2];
  doubled.triangles.push_back({t[0], t[2], t[1]});
  soup = soup_of(doubled);
  settle_copies(soup);
  EXPECT_EQ(soup.triangles.size(), 4U);
}

TEST(FaceCopies, a_surface_of_one_side_is_refused) {
  TriMesh strip;  // a Moebius strip of five triangles
  for (int i = 0; i < 5; ++i) {
    strip.points.emplace_back(std::cos(i * 1.2566), std::sin(i * 1.2566), i % 2);
  }
  strip.triangles = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 0, 4}, {4, 0, 1}};
  PolygonSoup soup = soup_of(strip);
  try {
    settle_copies(soup);
    FAIL() << "it has no orientation";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::not_oriented);
  }
}

}  // namespace
}  // namespace dupin::healing
