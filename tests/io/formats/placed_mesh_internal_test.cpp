#include <limits>

#include <gtest/gtest.h>

#include "formats/placed_mesh.h"

namespace dupin::formats {
namespace {

Eigen::Matrix3d matrix(const Vec3& x, const Vec3& y, const Vec3& z) {
  Eigen::Matrix3d result;
  result << x, y, z;
  return result;
}

TEST(PlacedMesh, mirrors_if_the_determinant_is_negative_however_small) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  EXPECT_FALSE(mirrors(matrix(x, y, z)));
  EXPECT_FALSE(mirrors(matrix(y, z, x)));
  EXPECT_TRUE(mirrors(matrix(y, x, z)));
  EXPECT_TRUE(mirrors(matrix(-x, -y, -z)));
  EXPECT_FALSE(mirrors(matrix(x, y, Vec3::Zero())));
  for (const double scale : {1e-300, 1e-120, 1e-40, 1e40, 1e300}) {
    EXPECT_TRUE(mirrors(scale * matrix(-x, y, z))) << scale;
    EXPECT_FALSE(mirrors(scale * matrix(x, y, z))) << scale;
    EXPECT_FALSE(mirrors(scale * matrix(-x, -y, z))) << scale;
  }
  // 1 - (1 + 2e-16) (1 - 2e-16) is 5e-32, and 0 in doubles.
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  EXPECT_FALSE(mirrors(matrix({1, 1 + kUlp, 0}, {1 - kUlp, 1, 0}, z)));
  EXPECT_TRUE(mirrors(matrix({1 - kUlp, 1, 0}, {1, 1 + kUlp, 0}, z)));
}

TEST(PlacedMesh, keeps_its_outside_outside) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  TriMesh mesh;
  Transform place;
  EXPECT_TRUE(append_placed(points, {{0, 1, 2}}, place, mesh));
  place.linear = -1e-110 * Eigen::Matrix3d::Identity();
  place.shift = {0, 0, 1};
  EXPECT_TRUE(append_placed(points, {{0, 1, 2}}, place, mesh));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 5, 4}}));
  EXPECT_EQ(mesh.points[4], Vec3(-1e-110, 0, 1));
}

TEST(PlacedMesh, beyond_the_range_of_doubles_is_none) {
  TriMesh mesh;
  Transform place;
  place.linear(0, 0) = 1e300;
  EXPECT_TRUE(append_placed({{1, 0, 0}}, {}, place, mesh));
  EXPECT_FALSE(append_placed({{1e300, 0, 0}}, {}, place, mesh));
  place.linear(0, 0) = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(append_placed({{0, 0, 0}}, {}, place, mesh));
  EXPECT_FALSE(append_placed({}, {}, place, mesh)) << "whatever it is of";
}

}  // namespace
}  // namespace dupin::formats
