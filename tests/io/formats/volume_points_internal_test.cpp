#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "formats/volume_points.h"
#include "io/formats/volume_sample.h"

namespace dupin::formats {
namespace {

TEST(VolumePoints, are_those_of_the_surface_and_then_those_inside) {
  VolumeMesh mesh = test::volume_sample();
  mesh.inner_points[0].y() = -0.0;
  const std::vector<Vec3> points = writable_points(mesh);
  ASSERT_EQ(points.size(), mesh.point_count());
  EXPECT_EQ(points.front(), mesh.surface.points.front());
  EXPECT_EQ(points.back(), mesh.inner_points[0]);
  EXPECT_FALSE(std::signbit(points.back().y()));
}

TEST(VolumePoints, of_meshes_that_no_file_can_hold_are_refused) {
  VolumeMesh far = test::volume_sample(), foreign = far, broken = far;
  far.inner_points[0].x() = std::numeric_limits<double>::infinity();
  foreign.tetrahedra[1][2] = 5;
  broken.surface.triangles[0][0] = 4;  // a point inside, but none of the surface
  for (const VolumeMesh& mesh : {far, foreign, broken}) {
    try {
      (void)writable_points(mesh);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
    }
  }
}

}  // namespace
}  // namespace dupin::formats
