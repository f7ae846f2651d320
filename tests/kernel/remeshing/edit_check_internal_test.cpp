#include <cmath>

#include <gtest/gtest.h>

#include "remeshing/edit_check.h"
#include "support/shapes.h"
#include "workshop_internal.h"

namespace dupin::remeshing {
namespace {

using test::Bench;

TEST(SmallestSine, is_that_of_the_smallest_angle) {
  const Vec3 a(0, 0, 0), b(1, 0, 0);
  EXPECT_NEAR(smallest_sine({a, b, Vec3(0.5, std::sqrt(0.75), 0)}), std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(smallest_sine({a, b, Vec3(1, 0.1, 0)}), std::sin(std::atan(0.1)), 1e-15);
  EXPECT_NEAR(smallest_sine({a, b, Vec3(0.5, 0.1, 0)}), std::sin(std::atan(0.2)), 1e-15);
  EXPECT_EQ(smallest_sine({a, b, Vec3(2, 0, 0)}), 0);
  EXPECT_EQ(smallest_sine({a, a, b}), 0);
}

TEST(EditCheck, sees_faces_turn_over_and_leave_the_surface) {
  Bench bench(dupin::test::box(Vec3::Zero(), Vec3(1, 1, 1)), {0.01, 1, 0.01});
  const WorkingMesh& mesh = bench.working;
  const std::uint32_t v = 0;
  const auto moved = [&](const Vec3& place) {
    Edit edit;
    edit.before.assign(mesh.around(v).begin(), mesh.around(v).end());
    for (const std::uint32_t f : edit.before) {
      edit.after.push_back(mesh.face(f));
    }
    edit.moved = {v, place};
    return edit;
  };
  const Edit little = moved(Vec3(-0.004, -0.004, -0.004)), far = moved(Vec3(-0.1, -0.1, -0.1)),
             over = moved(Vec3(3, 3, 3));
  EXPECT_TRUE(EditCheck(bench.shop, little).keeps_sides());
  EXPECT_TRUE(EditCheck(bench.shop, little).stays_near());
  EXPECT_TRUE(EditCheck(bench.shop, far).keeps_sides());
  EXPECT_FALSE(EditCheck(bench.shop, far).stays_near());
  EXPECT_FALSE(EditCheck(bench.shop, over).keeps_sides());
  EXPECT_NEAR(EditCheck(bench.shop, moved(mesh.place(v))).longest_edge_ratio(), std::sqrt(2),
              1e-12);
}

}  // namespace
}  // namespace dupin::remeshing
