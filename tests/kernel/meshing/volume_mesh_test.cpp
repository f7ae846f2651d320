#include "dupin/kernel/volume_mesh.h"

#include <gtest/gtest.h>

namespace dupin {
namespace {

TEST(VolumeMesh, has_the_points_of_its_surface_first) {
  // The first point is inside, the third one nowhere.
  TriMesh surface;
  surface.points = {{0.1, 0.1, 0.1}, {0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}};
  surface.triangles = {{1, 4, 3}};
  surface.names = {"patch"};
  surface.labels = {0};
  const VolumeMesh mesh = volume_mesh_of(surface, {{0, 1, 4, 3}});
  EXPECT_EQ(mesh.surface.points, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.inner_points, (std::vector<Vec3>{{0.1, 0.1, 0.1}}));
  EXPECT_EQ(mesh.surface.triangles, (std::vector<Triangle>{{0, 2, 1}}));
  EXPECT_EQ(mesh.tetrahedra, (std::vector<Tetrahedron>{{3, 0, 2, 1}}));
  EXPECT_EQ(mesh.surface.labels, surface.labels);
  EXPECT_EQ(mesh.point(3), Vec3(0.1, 0.1, 0.1));
  EXPECT_EQ(mesh.point_count(), 4U);
}

}  // namespace
}  // namespace dupin
