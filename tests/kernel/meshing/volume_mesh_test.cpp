#include "dupin/kernel/volume_mesh.h"

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/message_of.h"

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

TEST(VolumeMesh, corners_that_are_no_points_are_refused) {
  TriMesh surface;
  surface.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  surface.triangles = {{0, 2, 1}};
  const auto said = [&](const std::vector<Tetrahedron>& tetrahedra) {
    return test::message_of([&] { (void)volume_mesh_of(surface, tetrahedra); },
                            Errc::invalid_argument);
  };
  EXPECT_EQ(said({{0, 1, 2, 0}, {0, 1, 2, 1000000000}}),
            "tetrahedron 1 has the corner 1000000000; there are 3 points");
  surface.triangles[0][1] = 3;
  EXPECT_EQ(said({}), "triangle 0 has the corner 3; there are 3 points");
}

}  // namespace
}  // namespace dupin
