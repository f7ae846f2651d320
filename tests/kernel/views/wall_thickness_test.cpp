#include "dupin/kernel/wall_thickness.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/rounding.h"
#include "support/shapes.h"

namespace dupin {
namespace {

TriMesh hollow_box() {
  const Solid outer = Solid::from(test::labelled(test::box({0, 0, 0}, {10, 10, 10}), "outer"));
  const Solid inner = Solid::from(test::labelled(test::box({1, 2, 3}, {7, 6, 6}), "inner"));
  return to_mesh(subtract(outer, {&inner, 1})).mesh();
}

TEST(WallThickness, is_the_least_way_to_the_other_side) {
  const TriMesh mesh = hollow_box();
  const auto walls = thinnest_walls(mesh);
  ASSERT_EQ(walls.size(), 2);
  for (const WallPlace& wall : walls) {
    EXPECT_NEAR((wall.to - wall.from).norm(), wall.thickness, 1e-12);
    if (mesh.names[wall.label] == "inner") {
      EXPECT_NEAR(wall.thickness, 1, 1e-12);
      EXPECT_NEAR(wall.to[0], 0, 1e-12);
    } else {
      EXPECT_GE(wall.thickness, 1 - 1e-12);
    }
  }
}

// Between polygons of as many sides, the wall is thinnest between their middles.
TEST(WallThickness, of_a_tube_is_that_of_its_polygons) {
  constexpr std::uint32_t kSides = 48;
  const Solid inner = Solid::from(test::tube(8, -1, 21, kSides));
  const TriMesh mesh =
      to_mesh(subtract(Solid::from(test::tube(10, 0, 20, kSides)), {&inner, 1})).mesh();
  const auto walls = thinnest_walls(mesh);
  ASSERT_EQ(walls.size(), 1);
  EXPECT_NEAR(walls[0].thickness, 2 * std::cos(std::numbers::pi / kSides), 1e-9);
}

TEST(WallThickness, leaves_out_edges_where_a_solid_tapers_off) {
  // The sides of a tetrahedron are nowhere near parallel.
  EXPECT_TRUE(thinnest_walls(test::tetrahedron()).empty());
  EXPECT_TRUE(thinnest_walls(TriMesh{}).empty());
}

TEST(WallThickness, tries_every_label_however_few_ways_it_may) {
  TriMesh mesh = test::box({0, 0, 0}, {1, 2, 3});
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    mesh.labels.push_back(i);
    mesh.names.push_back(std::to_string(i));
  }
  const auto walls = thinnest_walls(mesh, 1);
  ASSERT_EQ(walls.size(), mesh.triangles.size());
  for (std::uint32_t i = 0; i < walls.size(); ++i) {
    EXPECT_EQ(walls[i].label, i);
  }
}

TEST(WallThickness, is_of_corners_that_are_points_and_angles_that_are_numbers) {
  TriMesh box = test::box({0, 0, 0}, {1, 1, 1});
  EXPECT_THROW((void)thinnest_walls(box, 100, std::nan("")), Error);
  box.triangles[0][0] = 8;
  EXPECT_THROW((void)thinnest_walls(box), Error);
}

}  // namespace
}  // namespace dupin
