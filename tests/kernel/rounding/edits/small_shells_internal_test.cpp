#include <numeric>

#include <gtest/gtest.h>

#include "rounding/edits/small_shells.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

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
