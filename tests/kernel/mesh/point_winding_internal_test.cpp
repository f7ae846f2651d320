#include <numeric>

#include <gtest/gtest.h>

#include "mesh/point_winding.h"
#include "support/shapes.h"

namespace dupin::mesh {
namespace {

int winding(const TriMesh& mesh, const Vec3& point) {
  std::vector<std::uint32_t> faces(mesh.triangles.size());
  std::iota(faces.begin(), faces.end(), 0);
  return winding_number({mesh.points, mesh.triangles}, faces,
                        {exact::exact_vector(point), 1, Eigen::AlignedBox3d(point, point)});
}

TEST(PointWinding, counts_surfaces_around_a_point) {
  const TriMesh nested =
      test::joined({test::box({0, 0, 0}, {4, 4, 4}), test::box({1, 1, 1}, {3, 3, 3}),
                    test::reversed(test::box({1.5, 1.5, 1.5}, {2.5, 2.5, 2.5}))});
  EXPECT_EQ(winding(nested, {0.5, 2, 2}), 1);
  EXPECT_EQ(winding(nested, {1.25, 2, 2}), 2);
  EXPECT_EQ(winding(nested, {2, 2, 2}), 1);
  EXPECT_EQ(winding(nested, {5, 2, 2}), 0);
  EXPECT_EQ(winding(nested, {-1, 2, 2}), 0);  // the ray runs through all of them
}

TEST(PointWinding, tells_neighbouring_doubles_apart) {
  const TriMesh box = test::box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(winding(box, {std::nextafter(1.0, 0.0), 0.5, 0.5}), 1);
  EXPECT_EQ(winding(box, {std::nextafter(1.0, 2.0), 0.5, 0.5}), 0);
}

TEST(PointWinding, sees_points_on_faces) {
  const TriMesh box = test::box({0, 0, 0}, {1, 1, 1});
  const auto touched = [&](const Vec3& point) {
    int count = 0;
    for (std::uint32_t face = 0; face < box.triangles.size(); ++face) {
      count += may_touch({box.points, box.triangles}, face, point) ? 1 : 0;
    }
    return count;
  };
  EXPECT_GT(touched({1, 0.25, 0.5}), 0);
  EXPECT_EQ(touched({std::nextafter(1.0, 0.0), 0.25, 0.5}), 0);
  EXPECT_EQ(touched({2, 0.25, 0.5}), 0);  // in the plane, beside the face
}

}  // namespace
}  // namespace dupin::mesh
