#include <cmath>
#include <numeric>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "mesh/ray_faces.h"
#include "support/shapes.h"

namespace dupin::mesh {
namespace {

WindingPoint winding_point(const Vec3& point) {
  return {exact::exact_vector(point), 1, Eigen::AlignedBox3d(point, point)};
}

// Points of a grid in which many are on faces, edges and corners, or beside them by one double.
std::vector<Vec3> places() {
  std::mt19937_64 random(7);
  std::vector<Vec3> result;
  for (int i = 0; i < 500; ++i) {
    Vec3 point;
    for (double& x : point) {
      x = double(random() % 13) / 2 - 1;
      x = random() % 4 == 0 ? std::nextafter(x, random() % 2 == 0 ? -9 : 9) : x;
    }
    result.push_back(point);
  }
  return result;
}

struct RayFacesCase : testing::Test {
  TriMesh mesh = test::joined({test::box({0, 0, 0}, {4, 4, 4}), test::box({1, 1, 1}, {3, 3, 3}),
                               test::reversed(test::box({1.5, 1.5, 1.5}, {2.5, 2.5, 2.5}))});
  std::vector<std::uint32_t> faces = std::vector<std::uint32_t>(mesh.triangles.size() - 12);

  RayFacesCase() { std::iota(faces.begin(), faces.end(), 12); }  // but the first box
};

TEST_F(RayFacesCase, wind_as_all_faces_do_however_many_points_are_asked_for) {
  const MeshView view(mesh.points, mesh.triangles);
  const RayFaces found(view, faces);
  int inside = 0;
  for (const Vec3& place : places()) {
    const WindingPoint point = winding_point(place);
    EXPECT_EQ(found.winding_number(point), winding_number(view, faces, point)) << place;
    inside += found.winding_number(point) != 0 ? 1 : 0;
  }
  EXPECT_GT(inside, 10);
}

TEST_F(RayFacesCase, are_asked_by_several_threads) {
  const MeshView view(mesh.points, mesh.triangles);
  const std::vector<Vec3> all = places();
  for (int round = 0; round < 20; ++round) {
    const RayFaces found(view, faces);
    std::vector<int> windings(2 * all.size());
    const auto ask = [&](std::size_t from) {
      for (std::size_t i = from; i < windings.size(); i += 2) {
        windings[i] = found.winding_number(winding_point(all[i / 2]));
      }
    };
    std::thread other(ask, 1);
    ask(0);
    other.join();
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(windings[2 * i], windings[2 * i + 1]);
    }
  }
}

}  // namespace
}  // namespace dupin::mesh
