#include <algorithm>

#include <gtest/gtest.h>

#include "mesh/coincident_points.h"
#include "rounding/shell_check.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

TEST(CrossedContacts, are_edges_where_sheets_pass_through_each_other) {
  // Two boxes that touch along an edge; then the second one's corner lies in the first.
  const TriMesh touching =
      test::joined({test::box({0, 0, 0}, {2, 2, 2}), test::box({2, 2, 0}, {4, 4, 2})});
  const auto representatives = mesh::coincident_representatives(touching.points);
  EXPECT_TRUE(crossed_contacts({touching.points, touching.triangles}, representatives).empty());
  TriMesh crossed = touching;
  for (std::size_t v = 8; v < 16; ++v) {
    Vec3& p = crossed.points[v];
    if (p.x() == 4 && p.y() == 2) {
      p.x() = 1;  // across the side x = 2 of the first box
    }
  }
  const auto faces = crossed_contacts({crossed.points, crossed.triangles}, representatives);
  EXPECT_EQ(faces.size(), 4);
  EXPECT_TRUE(std::ranges::any_of(faces, [](std::uint32_t f) { return f < 12; }));
  EXPECT_TRUE(std::ranges::any_of(faces, [](std::uint32_t f) { return f >= 12; }));
}

}  // namespace
}  // namespace dupin::rounding
