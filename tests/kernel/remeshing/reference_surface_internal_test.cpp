#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "remeshing/reference_surface.h"
#include "support/shapes.h"

namespace dupin::remeshing {
namespace {

using dupin::test::box;
using dupin::test::tube;

TEST(ReferenceSurface, bounds_are_never_below_sampled_distances) {
  const TriMesh mesh = tube(2, 0, 5, 40);
  const std::vector<std::uint32_t> regions(mesh.triangles.size(), 0);
  const ReferenceSurface surface(mesh.points, mesh.triangles, regions);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  int proved = 0;
  for (int i = 0; i < 100; ++i) {
    std::array<Vec3, 3> t;
    const double around = 3 * unit(random), up = 2.5 + 2 * unit(random);
    for (Vec3& corner : t) {
      const double angle = around + 0.1 * unit(random);
      corner = Vec3(2 * std::cos(angle), 2 * std::sin(angle), up + 0.3 * unit(random));
    }
    const auto bound = surface.bound(t, 0, 0.03);
    proved += bound ? 1 : 0;
    for (int k = 0; k < 50 && bound; ++k) {
      double u = std::abs(unit(random)), v = std::abs(unit(random));
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      const auto near =
          surface.nearest(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]), 0, Vec3::Zero(), 0.01, 1);
      ASSERT_TRUE(near);
      EXPECT_LE(near->distance, *bound + 1e-12);
    }
  }
  EXPECT_GT(proved, 80);
}

TEST(ReferenceSurface, takes_no_more_parts_for_a_smaller_distance) {
  // Across the 400 slivers of an end: halves as small as the distance would be millions.
  const TriMesh mesh = tube(2, 0, 5, 400);
  const std::vector<std::uint32_t> regions(mesh.triangles.size(), 0);
  const ReferenceSurface surface(mesh.points, mesh.triangles, regions);
  const std::array<Vec3, 3> across = {Vec3(-1.1, -1, 0), Vec3(1.2, -0.9, 0), Vec3(0.1, 1.3, 0)};
  const auto bound = surface.bound(across, 0, 1e-9);
  ASSERT_TRUE(bound);
  EXPECT_LE(*bound, 1e-9);
}

TEST(ReferenceSurface, proves_no_more_than_there_is) {
  const TriMesh mesh = box(Vec3::Zero(), Vec3(1, 1, 1));
  const std::vector<std::uint32_t> regions(mesh.triangles.size(), 0);
  const ReferenceSurface surface(mesh.points, mesh.triangles, regions);
  const std::array<Vec3, 3> across = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 1)};
  EXPECT_FALSE(surface.bound(across, 0, 0.4));  // its middle is half a unit inside
  EXPECT_TRUE(surface.bound(across, 0, 0.6));
  EXPECT_FALSE(surface.bound(across, 1, 10));  // there is no such region
  EXPECT_TRUE(surface.is_within(Vec3(0.5, 0.5, 1.1), 0, 0.11));
  EXPECT_FALSE(surface.is_within(Vec3(0.5, 0.5, 1.1), 0, 0.09));
}

}  // namespace
}  // namespace dupin::remeshing
