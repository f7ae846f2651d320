#include <gtest/gtest.h>

#include "drawings/shading.h"

namespace dupin::drawings {
namespace {

TEST(Shading, covers_the_solid_and_nothing_else) {
  // A tetrahedron whose shadow is the triangle (0, 0), (10, 0), (0, 10).
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  const Solid solid = Solid::from(mesh);
  PaperSheet sheet;
  sheet.size = {20, 20};
  sheet.origin = {5, 15};
  const Picture picture = shaded(solid, view_along(-Vec3::UnitZ()), sheet, 2);
  ASSERT_EQ(picture.width, 40);
  ASSERT_EQ(picture.height, 40);
  const auto alpha = [&](double x, double y) {
    return picture.pixels[std::size_t(2 * y) * 40 + std::size_t(2 * x)] >> 24;
  };
  EXPECT_EQ(alpha(6, 14), 255U);
  EXPECT_EQ(alpha(8, 12), 255U);
  EXPECT_EQ(alpha(14, 6), 0U);
  EXPECT_EQ(alpha(4, 16), 0U);
  EXPECT_EQ(picture.pixels, shaded(solid, view_along(-Vec3::UnitZ()), sheet, 2).pixels);
}

}  // namespace
}  // namespace dupin::drawings
