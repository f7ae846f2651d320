#include <array>

#include <gtest/gtest.h>

#include "mesh/projected_areas.h"
#include "support/shapes.h"

namespace dupin::mesh {
namespace {

TEST(ProjectedAreas, are_of_both_sides_along_each_axis) {
  const TriMesh box = test::box({0, 0, 0}, {1, 2, 3});
  const std::array<mpq_class, 3> areas = {4 * 6, 4 * 3, 4 * 2};
  EXPECT_EQ(projected_areas({box.points, box.triangles}), areas);
  const TriMesh turned = test::reversed(box);
  EXPECT_EQ(projected_areas({turned.points, turned.triangles}), areas);
  EXPECT_EQ(projected_areas({{}, {}}), (std::array<mpq_class, 3>{}));
}

}  // namespace
}  // namespace dupin::mesh
