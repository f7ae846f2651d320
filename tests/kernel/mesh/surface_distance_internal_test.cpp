#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/surface_distance.h"
#include "support/mesh_distance.h"
#include "support/shapes.h"

namespace dupin::mesh {
namespace {

using dupin::test::tube;

/// A square with corners at +-1 in the plane of a height, in n times n squares of two triangles.
TriMesh sheet(int n, double height) {
  TriMesh mesh;
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; k <= n; ++k) {
      mesh.points.emplace_back(2.0 * i / n - 1, 2.0 * k / n - 1, height);
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const auto at = static_cast<std::uint32_t>(i * (n + 1) + k);
      const auto next = at + static_cast<std::uint32_t>(n) + 1;
      mesh.triangles.push_back({at, next, next + 1});
      mesh.triangles.push_back({at, next + 1, at + 1});
    }
  }
  return mesh;
}

TEST(SurfaceDistance, of_parallel_sheets_is_proved_and_no_less) {
  for (const int n : {1, 3, 40}) {
    const TriMesh mesh = sheet(n, 0.25);
    const std::vector<std::uint32_t> regions(mesh.triangles.size(), 7);
    const ReferenceSurface surface(mesh.points, mesh.triangles, regions);
    const std::array<Vec3, 3> triangle = {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0.3, 0.9, 0)};
    const auto bound = surface.bound(triangle, 7, 0.26);
    ASSERT_TRUE(bound);
    EXPECT_GE(*bound, 0.25);
    EXPECT_LE(*bound, 0.26);
    EXPECT_FALSE(surface.bound(triangle, 7, 0.24));
    EXPECT_FALSE(surface.bound(triangle, 6, 10)) << "another region";
  }
}

// A cut within rounding of an edge left the part as it was, with one corner more each time: of
// thousands of corners, every pair was looked at, which took an hour.
TEST(SurfaceDistance, gives_up_where_cuts_get_nowhere) {
  const std::vector<Vec3> points = {{3.8785608824166897, -4.9556954886336291, -4.54376220703125},
                                    {3.68731689453125, -4.94921875, -4.27685546875},
                                    {3.695613148013313, -4.9437670238488938, -4.3008239409420552},
                                    {4.45428466796875, -5.470458984375, -4.27685546875}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 3, 1}};
  const std::vector<std::uint32_t> regions(2, 0);
  const std::array<Vec3, 3> triangle = {
      Vec3(3.688843726380278, -4.9418442487362126, -4.2843866231760908), points[1],
      Vec3(3.6857416008565345, -4.9409633925227769, -4.27685546875)};
  const ReferenceSurface surface(points, triangles, regions);
  const auto bound = surface.bound(triangle, 0, 0.0075);
  EXPECT_TRUE(!bound || *bound <= 0.0075);
}

TEST(SurfaceDistance, sees_a_hole_between_triangles) {
  TriMesh mesh = sheet(20, 0);
  const std::array<Vec3, 3> triangle = {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0)};
  const auto bound_without = [&](std::size_t face) {
    TriMesh holed = mesh;
    holed.triangles.erase(holed.triangles.begin() + static_cast<std::ptrdiff_t>(face));
    const std::vector<std::uint32_t> regions(holed.triangles.size(), 0);
    return ReferenceSurface(holed.points, holed.triangles, regions)
        .bound(triangle, 0, 0.01)
        .has_value();
  };
  EXPECT_TRUE(bound_without(1)) << "beside the triangle";
  EXPECT_FALSE(bound_without(20 * 2 * 15 + 10)) << "below it";
}

TEST(SurfaceDistance, bounds_what_is_sampled) {
  const TriMesh fine = tube(10, 0, 60, 256), coarse = tube(10, 0, 60, 24);
  const std::vector<std::uint32_t> regions(fine.triangles.size(), 0);
  const ReferenceSurface surface(fine.points, fine.triangles, regions);
  const double sagitta = 10 * (1 - std::cos(M_PI / 24)), cap = 0.02;
  for (const auto& [a, b, c] : coarse.triangles) {
    const std::array<Vec3, 3> corners = {coarse.points[a], coarse.points[b], coarse.points[c]};
    const auto bound = surface.bound(corners, 0, sagitta + cap);
    ASSERT_TRUE(bound);
    EXPECT_LE(test::distance_to((corners[0] + corners[1] + corners[2]) / 3, fine), *bound + 1e-12);
  }
}

TEST(SurfaceDistance, nearest_is_of_the_region_asked_for) {
  const TriMesh low = sheet(4, 0), high = sheet(4, 1);
  const TriMesh both = test::joined({low, high});
  std::vector<std::uint32_t> regions(both.triangles.size(), 0);
  std::fill(regions.begin() + static_cast<std::ptrdiff_t>(low.triangles.size()), regions.end(), 1);
  const ReferenceSurface surface(both.points, both.triangles, regions);
  const Vec3 point(0.1, 0.2, 0.25);
  EXPECT_EQ(surface.nearest(point, 0, 2)->point, Vec3(0.1, 0.2, 0));
  EXPECT_EQ(surface.nearest(point, 1, 2)->point, Vec3(0.1, 0.2, 1));
  EXPECT_FALSE(surface.nearest(point, 1, 0.5));
  EXPECT_FALSE(surface.nearest(point, 2, 2));
}

TEST(SurfaceDistance, nearest_on_a_triangle_is_in_its_plane_on_an_edge_or_at_a_corner) {
  const Vec3 a(0, 0, 0), b(2, 0, 0), c(0, 2, 0);
  EXPECT_EQ(nearest_on_triangle(Vec3(0.5, 0.5, 3), a, b, c), Vec3(0.5, 0.5, 0));
  EXPECT_EQ(nearest_on_triangle(Vec3(2, 2, 1), a, b, c), Vec3(1, 1, 0));
  EXPECT_EQ(nearest_on_triangle(Vec3(-1, -2, 1), a, b, c), a);
  EXPECT_EQ(nearest_on_triangle(Vec3(1, 1, 0), a, b, b), Vec3(1, 0, 0)) << "an edge";
}

}  // namespace
}  // namespace dupin::mesh
