#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/connected_components.h"
#include "rounding/shell_sides.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

Eigen::AlignedBox3d box_about_faces(const EditedMesh& mesh, std::uint32_t point) {
  Eigen::AlignedBox3d box;
  for (const std::uint32_t face : mesh.faces(point)) {
    for (const std::uint32_t corner : mesh.triangle(face)) {
      box.extend(mesh.point(corner));
    }
  }
  return box;
}

// A pyramid over a triangle with a point below its middle: its tip may go to a corner of the base,
// which leaves the lower half, but not where that point is above the base.
TEST(ShellSides, stay_unless_faces_pass_all_others) {
  for (const bool is_dented : {false, true}) {
    TriMesh shape;
    shape.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 4}, {1, 1, is_dented ? 1.0 : -1.0}};
    shape.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}};
    for (const bool is_void : {false, true}) {
      const TriMesh shell = is_void ? test::reversed(shape) : shape;
      const TriMesh two = test::joined({test::box({-9, -9, -9}, {-8, -8, -8}), shell});
      const std::vector<std::uint32_t> shells =
          connected_components(two.triangles, two.points.size());
      std::vector<std::uint32_t> own(two.points.size());
      for (std::uint32_t i = 0; i < own.size(); ++i) {
        own[i] = i;
      }
      const EditedMesh mesh(two.points, two.triangles, {}, own);
      ShellSides sides(shells);
      const std::uint32_t tip = 8 + 3, corner = 8;
      EXPECT_EQ(sides.stay(mesh, tip, corner, box_about_faces(mesh, tip)), !is_dented);
      EXPECT_TRUE(sides.stay(mesh, 0, 1, box_about_faces(mesh, 0)));
    }
  }
}

}  // namespace
}  // namespace dupin::rounding
