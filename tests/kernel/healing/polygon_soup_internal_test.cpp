#include <algorithm>
#include <map>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "healing/degenerate_faces.h"
#include "healing/face_copies.h"
#include "healing/polygon_soup.h"
#include "mesh/exact_mesh.h"
#include "mesh/measure.h"
#include "support/shapes.h"

namespace dupin::healing {
namespace {

PolygonSoup soup_of(const TriMesh& mesh) {
  PolygonSoup soup{mesh.points, mesh.triangles, {}};
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    soup.sources.push_back(i);
  }
  return soup;
}

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

std::map<std::array<std::uint32_t, 2>, int> edge_balance(const PolygonSoup& soup) {
  std::map<std::array<std::uint32_t, 2>, int> balance;
  for (const Triangle& t : soup.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  return balance;
}

bool is_balanced(const PolygonSoup& soup) {
  return std::ranges::all_of(edge_balance(soup), [](const auto& e) { return e.second == 0; });
}

int volume_sign(const PolygonSoup& soup) {
  return mesh::volume_sign({soup.points, soup.triangles});
}

TEST(PolygonSoup, merging_points_closes_what_was_torn) {
  std::mt19937 random(1);
  for (const TriMesh& mesh : {test::frame(), test::tube(1, 0, 2, 7)}) {
    RepairReport report;
    const PolygonSoup soup = merge_duplicate_points(torn(mesh, random), report);
    EXPECT_EQ(report.merged_points, 3 * mesh.triangles.size() - mesh.points.size());
    EXPECT_TRUE(is_balanced(soup));
    EXPECT_EQ(soup.sources.size(), mesh.triangles.size());
  }
}

TEST(PolygonSoup, faces_without_area_go_and_leave_no_slit) {
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
  RepairReport report;
  drop_degenerate_faces(soup, report);
  EXPECT_EQ(report.degenerate_faces, 2U);
  EXPECT_TRUE(is_balanced(soup));
  EXPECT_EQ(soup.triangles.size(), 14U);
  EXPECT_EQ(mesh::exact_volume({soup.points, soup.triangles}), 8);
  for (const Triangle& t : soup.triangles) {
    const Vec3 a = soup.points[t[0]];
    EXPECT_FALSE((soup.points[t[1]] - a).cross(soup.points[t[2]] - a).isZero(0));
  }
}

TEST(PolygonSoup, of_copies_of_faces_one_stays) {
  TriMesh mesh = test::frame();
  const Triangle t = mesh.triangles[5];
  mesh.triangles.push_back({t[1], t[2], t[0]});
  mesh.triangles.push_back(t);
  PolygonSoup soup = soup_of(mesh);
  RepairReport report;
  (void)settle_copies(soup, report);
  EXPECT_EQ(report.duplicate_faces, 2U);
  EXPECT_TRUE(is_balanced(soup));
}

TEST(PolygonSoup, of_faces_that_cover_both_ways_none_stays_unless_needed) {
  // A wall within a closed surface, run both ways, is of no use.
  TriMesh wall = test::box({0, 0, 0}, {1, 1, 1});
  wall.triangles.push_back({0, 3, 7});
  wall.triangles.push_back({0, 7, 3});
  PolygonSoup soup = soup_of(wall);
  RepairReport report;
  (void)settle_copies(soup, report);
  EXPECT_EQ(report.duplicate_faces, 2U);
  EXPECT_EQ(soup.triangles, test::box({0, 0, 0}, {1, 1, 1}).triangles);
  // A face of the surface itself is.
  TriMesh doubled = test::tetrahedron();
  const Triangle t = doubled.triangles[2];
  doubled.triangles.push_back({t[0], t[2], t[1]});
  soup = soup_of(doubled);
  (void)settle_copies(soup, report);
  EXPECT_EQ(soup.triangles.size(), 4U);
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
    RepairReport report;
    turn_shells_outward(soup, settle_copies(soup, report), report);
    EXPECT_TRUE(is_balanced(soup));
    // Most faces of each shell were right.
    EXPECT_EQ(soup.triangles, mesh.triangles) << round;
    EXPECT_EQ(report.turned_faces, count);
  }
}

TEST(PolygonSoup, a_shell_that_no_other_encloses_is_turned_outward_as_a_whole) {
  PolygonSoup soup = soup_of(test::reversed(test::frame()));
  ASSERT_EQ(volume_sign(soup), -1);
  RepairReport report;
  turn_shells_outward(soup, settle_copies(soup, report), report);
  EXPECT_EQ(volume_sign(soup), 1);
  EXPECT_EQ(report.turned_faces, soup.triangles.size());
}

TEST(PolygonSoup, a_surface_of_one_side_is_refused) {
  TriMesh strip;  // a Moebius strip of five triangles
  for (int i = 0; i < 5; ++i) {
    strip.points.emplace_back(std::cos(i * 1.2566), std::sin(i * 1.2566), i % 2);
  }
  strip.triangles = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 0, 4}, {4, 0, 1}};
  PolygonSoup soup = soup_of(strip);
  RepairReport report;
  try {
    turn_shells_outward(soup, settle_copies(soup, report), report);
    FAIL() << "it has no orientation";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::not_oriented);
  }
}

}  // namespace
}  // namespace dupin::healing
