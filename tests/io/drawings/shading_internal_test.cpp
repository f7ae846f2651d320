#include <gtest/gtest.h>

#include "drawings/shading.h"
#include "support/shapes.h"

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
  const Picture picture = shaded(solid, {}, view_along(-Vec3::UnitZ()), sheet, 2);
  ASSERT_EQ(picture.width, 40);
  ASSERT_EQ(picture.height, 40);
  const auto alpha = [&](double x, double y) {
    return picture.pixels[std::size_t(2 * y) * 40 + std::size_t(2 * x)] >> 24;
  };
  EXPECT_EQ(alpha(6, 14), 255U);
  EXPECT_EQ(alpha(8, 12), 255U);
  EXPECT_EQ(alpha(14, 6), 0U);
  EXPECT_EQ(alpha(4, 16), 0U);
  EXPECT_EQ(picture.pixels, shaded(solid, {}, view_along(-Vec3::UnitZ()), sheet, 2).pixels);
}

TEST(Shading, a_part_has_one_colour_that_of_the_document_or_its_own) {
  TriMesh mesh = test::box({0, 0, 0}, {10, 10, 10});
  mesh.names = {"a", "a.end", "b"};
  const auto top = [&mesh](std::uint32_t label, const std::map<std::string, std::string>& colours) {
    mesh.labels.assign(mesh.triangles.size(), label);
    PaperSheet sheet;
    sheet.size = {20, 20};
    sheet.origin = {5, 15};
    return shaded(Solid::from(mesh), colours, view_along(-Vec3::UnitZ()), sheet, 1)
        .pixels.at(10 * 20 + 10);
  };
  EXPECT_EQ(top(0, {}), top(1, {}));
  EXPECT_NE(top(0, {}), top(2, {}));
  const std::uint32_t red = top(1, {{"a", "#ff0000"}});
  EXPECT_GT(red >> 16 & 255, 150U);  // in the light
  EXPECT_LT(red & 255, 60U);
  EXPECT_EQ(top(2, {{"a", "#ff0000"}}), top(2, {}));
}

}  // namespace
}  // namespace dupin::drawings
