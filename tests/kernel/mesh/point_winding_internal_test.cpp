#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

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

// Needles across the ray, which most boxes about them meet: those that it passes are told in plain
// numbers, those that it all but meets exactly.
TEST(PointWinding, of_slanted_needles_is_that_of_their_planes) {
  std::mt19937_64 random(3);
  const auto below = [&](int n) { return double(random() % std::uint64_t(n)); };
  int around = 0;
  for (const double unit : {1., 0x1p-200, 0x1p300, 0x1p-1040}) {
    for (int i = 0; i < 2000; ++i) {
      const Vec3 tip(below(64) + 64, below(64), below(64));
      const Vec3 a(0, 0, 0), b(0, 1 + below(2), below(2)), c(0, below(2), 1 + below(2));
      const Vec3 place =
          (1 + below(40)) / 64 * tip + Vec3(0, below(4) / 2 - 0.5, below(4) / 2 - 0.5);
      const TriMesh needle{{unit * a, unit * b, unit * c, unit * tip},
                           {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
      const auto side = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
        return (q - p).cross(r - p).dot(place - p);  // of whole numbers: exact
      };
      const std::array<double, 4> sides = {side(a, c, b), side(a, b, tip), side(b, c, tip),
                                           side(c, a, tip)};
      if (std::ranges::count(sides, 0.) == 0 && (b - a).cross(c - a).x() > 0) {
        const bool is_inside = std::ranges::all_of(sides, [](double s) { return s < 0; });
        EXPECT_EQ(winding(needle, unit * place), is_inside ? 1 : 0) << unit << ' ' << i;
        around += is_inside ? 1 : 0;
      }
    }
  }
  EXPECT_GT(around, 100);
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
