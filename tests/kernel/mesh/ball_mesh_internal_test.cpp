#include <cmath>
#include <random>

#include <CGAL/Interval_nt.h>
#include <gtest/gtest.h>

#include "exact/exact_numbers.h"
#include "mesh/ball_mesh.h"
#include "mesh/measure.h"

namespace dupin::mesh {
namespace {

/// A tetrahedron at a place with thirds for coordinates, its apex a third of `height` above the
/// middle of its base.
ExactMesh tetrahedron(double height, double place) {
  ExactMesh mesh;
  const CGAL::Mpzf z(place);
  const auto add = [&](double x, double y, double above) {
    mesh.implicit.push_back({x, y, z + CGAL::Mpzf(above), 3});
    mesh.points.emplace_back(x / 3, y / 3, (place + above) / 3);
  };
  add(0, 0, 0);
  add(3, 0, 0);
  add(0, 3, 0);
  add(1, 1, height);
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

struct BallMeshes : testing::Test {
  CGAL::Protect_FPU_rounding<true> upward;
};

TEST_F(BallMeshes, tell_the_sign_of_what_is_thinner_than_doubles_are_apart) {
  for (int exponent = 0; exponent > -70; --exponent) {
    for (const double side : {1, -1}) {
      const ExactMesh mesh = tetrahedron(side * std::ldexp(1, exponent), 1e3);
      EXPECT_EQ(volume_sign(BallMesh(MeshView(mesh), mesh.triangles)), side) << exponent;
      EXPECT_EQ(volume_sign(MeshView(mesh)), side) << exponent;
    }
  }
}

TEST_F(BallMeshes, do_not_tell_what_they_cannot) {
  for (const double height : {0.0, 0x1p-120, -0x1p-120}) {
    const ExactMesh mesh = tetrahedron(height, 1e3);
    EXPECT_EQ(volume_sign(BallMesh(MeshView(mesh), mesh.triangles)), 0);
    EXPECT_EQ(volume_sign(MeshView(mesh)), (height > 0) - (height < 0)) << "exact numbers do";
  }
  const ExactMesh mesh = tetrahedron(1, 1e3);
  EXPECT_EQ(volume_sign(BallMesh(MeshView(mesh), {})), 0);
}

TEST_F(BallMeshes, agree_with_exact_volumes_or_say_nothing) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  int known = 0, thin = 0;
  for (int round = 0; round < 2000; ++round) {
    const ExactMesh mesh = tetrahedron(
        std::ldexp(coordinate(random), -static_cast<int>(round % 130)), 1e3 * coordinate(random));
    const int sign = volume_sign(BallMesh(MeshView(mesh), mesh.triangles));
    const int exact = sgn(exact_volume(MeshView(mesh)));
    ASSERT_TRUE(sign == 0 || sign == exact) << round;
    ASSERT_EQ(volume_sign(MeshView(mesh)), exact) << round;
    known += sign != 0 ? 1 : 0;
    thin += sign == 0 ? 1 : 0;
  }
  EXPECT_GT(known, 1000);
  EXPECT_GT(thin, 100);
}

TEST_F(BallMeshes, have_the_used_points_once) {
  const ExactMesh mesh = tetrahedron(1, 0);
  const BallMesh two(MeshView(mesh), std::span(mesh.triangles).first(1));
  EXPECT_EQ(two.points.size(), 3);
  EXPECT_EQ(two.triangles, (std::vector<Triangle>{{0, 2, 1}}));
  EXPECT_EQ(two.points[1][0].high() + two.points[1][0].low(), 1);
}

}  // namespace
}  // namespace dupin::mesh
