#include "dupin/kernel/fill.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "kernel/meshing/solver_mesh_checks.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using test::kDegree;

double volume(const VolumeMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c, d] : mesh.tetrahedra) {
    const Vec3& p = mesh.point(a);
    const double volume = (mesh.point(b) - p).cross(mesh.point(c) - p).dot(mesh.point(d) - p) / 6;
    EXPECT_GT(volume, 0);
    sum += volume;
  }
  return sum;
}

TEST(Fill, of_a_tee_is_the_solid_in_tetrahedra) {
  const Solid tee =
      unite(std::vector{Solid::from(test::labelled(test::tube(10, 0, 60, 64), "run")),
                        Solid::from(test::labelled(
                            test::moved(test::tube(4, 0, 60, 32), Vec3(3, 0, 30)), "branch"))});
  const Filled filled = fill(tee, {.distance = 0.2, .largest_edge = 6});
  const VolumeMesh& mesh = filled.mesh;
  const Solid surface = Solid::from(mesh.surface);
  EXPECT_NEAR(volume(mesh), surface.volume(), 1e-9 * surface.volume());
  EXPECT_NEAR(surface.volume(), tee.volume(), 0.2 * tee.area());
  EXPECT_EQ(mesh.surface.names, tee.names());
  EXPECT_EQ(filled.report.poor_triangles, 0U);
  EXPECT_GE(test::smallest_angle(mesh.surface), 25 * kDegree);
  EXPECT_GT(mesh.inner_points.size(), 10U);
  EXPECT_GT(filled.smallest_dihedral_angle, 4 * kDegree);
  EXPECT_LT(filled.smallest_dihedral_angle, 71 * kDegree);
  // Every point has a tetrahedron, and no edge is longer than allowed.
  std::vector<int> used(mesh.point_count(), 0);
  for (const Tetrahedron& t : mesh.tetrahedra) {
    for (const std::uint32_t v : t) {
      used.at(v) = 1;
      EXPECT_LE((mesh.point(v) - mesh.point(t[0])).norm(), 6);
    }
  }
  EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
}

TEST(Fill, of_cavities_leaves_them_empty) {
  const Solid room = subtract(Solid::from(test::box(Vec3::Zero(), Vec3(6, 6, 6))),
                              std::vector{Solid::from(test::box(Vec3(2, 2, 2), Vec3(4, 4, 4)))});
  const Filled filled = fill(room, {.distance = 0.02, .largest_edge = 2});
  EXPECT_NEAR(volume(filled.mesh), 208, 1e-9);
}

TEST(Fill, of_a_plate_refuses_to_be_finer_than_it_is_thick_without_end) {
  const auto plate = [](double thickness) {
    return Solid::from(test::box(Vec3::Zero(), Vec3(1, 1, thickness)));
  };
  for (const double thickness : {1e-4, 1e-9}) {
    try {
      (void)fill(plate(thickness), {.distance = 0.01, .largest_edge = 0.3});
      ADD_FAILURE() << thickness;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::limit_exceeded);
      EXPECT_NE(error.message().find("thick"), std::string::npos) << error.message();
    }
  }
  EXPECT_GT(fill(plate(0.1), {.distance = 0.01, .largest_edge = 0.3}).mesh.tetrahedra.size(), 0U);
}

TEST(Fill, of_nothing_is_nothing) {
  EXPECT_TRUE(fill(Solid(), {.distance = 1}).mesh.tetrahedra.empty());
}

}  // namespace
}  // namespace dupin
