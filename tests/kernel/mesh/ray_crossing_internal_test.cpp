#include <random>

#include <gtest/gtest.h>

#include "dupin/kernel/mesh.h"
#include "mesh/ray_crossing.h"
#include "support/shapes.h"

namespace dupin::mesh {
namespace {

// In integers, along any axis.
struct TriangleAndStart {
  std::array<Vec3, 3> corners;
  Vec3 start;
  int axis;

  [[nodiscard]] static int sign(double x) { return (x > 0) - (x < 0); }
  [[nodiscard]] bool is_above(std::size_t i) const {
    return corners[i][(axis + 2) % 3] > start[(axis + 2) % 3];
  }
  [[nodiscard]] int turn(std::size_t i, std::size_t j) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Vec3 along = corners[j] - corners[i], to = start - corners[i];
    return sign(along[u] * to[v] - along[v] * to[u]);
  }
  [[nodiscard]] int side() const {
    return sign((corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(start - corners[0]));
  }
};

int crossings(const TriMesh& mesh, const Vec3& start, int axis, int direction) {
  int sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const TriangleAndStart triangle{
        {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]}, start, axis};
    sum += ray_crossing(triangle, direction);
  }
  return sum;
}

// Rays from points of an integer grid pass through edges and corners of the frame and lie in its
// faces; from inside they leave it once more than they enter it.
TEST(RayCrossing, counts_one_from_inside_and_none_from_outside) {
  TriMesh frame = test::frame();  // |x|, |y| <= 3 but for the hole |x|, |y| < 1; |z| <= 1
  for (Vec3& p : frame.points) {
    p *= 2;
  }
  for (int x = -8; x <= 8; ++x) {
    for (int y = -8; y <= 8; ++y) {
      for (int z = -3; z <= 3; ++z) {
        const int most = std::max(std::abs(x), std::abs(y));
        if (most == 6 || most == 2 || std::abs(z) == 2) {
          continue;  // on the surface, or level with it
        }
        const bool inside = most < 6 && most > 2 && std::abs(z) < 2;
        for (int axis = 0; axis < 3; ++axis) {
          for (const int direction : {-1, 1}) {
            EXPECT_EQ(crossings(frame, Vec3(x, y, z), axis, direction), inside ? 1 : 0)
                << x << ' ' << y << ' ' << z << " along " << axis;
          }
        }
      }
    }
  }
}

TEST(RayCrossing, passes_no_edge_nor_corner_twice) {
  // Tetrahedra around the start, whose corners lie exactly before and behind it.
  const TriMesh octahedron = [] {
    TriMesh mesh;
    mesh.points = {Vec3(4, 0, 0),  Vec3(-4, 0, 0), Vec3(0, 4, 0),
                   Vec3(0, -4, 0), Vec3(0, 0, 4),  Vec3(0, 0, -4)};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    return mesh;
  }();
  for (int x = -5; x <= 5; ++x) {
    for (int y = -5; y <= 5; ++y) {
      for (int z = -5; z <= 5; ++z) {
        const int distance = std::abs(x) + std::abs(y) + std::abs(z);
        for (int axis = 0; axis < 3 && distance != 4; ++axis) {
          for (const int direction : {-1, 1}) {
            EXPECT_EQ(crossings(octahedron, Vec3(x, y, z), axis, direction), distance < 4 ? 1 : 0);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace dupin::mesh
