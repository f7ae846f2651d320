#include <algorithm>
#include <numeric>

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

TEST(SmallShells, are_removed_within_the_reach) {
  const TriMesh mesh =
      test::joined({test::box({0, 0, 0}, {9, 9, 9}), test::tetrahedron({20, 0, 0}, 0.01),
                    test::tetrahedron({30, 0, 0}, 0.01)});
  std::vector<std::uint32_t> own(mesh.points.size());
  std::iota(own.begin(), own.end(), 0U);
  EditedMesh edited(mesh.points, mesh.triangles, {}, own);
  EXPECT_EQ(remove_small_shells(edited, {0, 12, 13}, 0.001), 0);
  EXPECT_EQ(remove_small_shells(edited, {0, 12, 13}, 0.1), 1) << "the box is large, one not named";
  for (std::uint32_t f = 0; f < edited.face_count(); ++f) {
    EXPECT_EQ(edited.alive(f), f < 12 || f >= 16);
  }
}

}  // namespace
}  // namespace dupin::rounding
