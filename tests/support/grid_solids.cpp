#include "support/grid_solids.h"

#include <array>
#include <vector>

#include "support/shapes.h"

namespace dupin::test {
namespace {

int between(std::mt19937& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

// Corners of convex polygons, counter-clockwise, on the integer points of a square of side 4.
const std::vector<std::vector<std::array<int, 2>>>& outlines() {
  static const std::vector<std::vector<std::array<int, 2>>> all = {
      {{0, 0}, {3, 0}, {0, 3}},
      {{0, 0}, {2, 1}, {1, 3}},
      {{0, 0}, {3, 0}, {3, 2}, {0, 2}},
      {{1, 0}, {2, 0}, {3, 1}, {3, 2}, {2, 3}, {1, 3}, {0, 2}, {0, 1}},
      {{1, 0}, {3, 1}, {2, 3}, {0, 2}},
      {{0, 0}, {4, 0}, {4, 1}, {3, 3}, {1, 4}},
  };
  return all;
}

TriMesh prism(const std::vector<std::array<int, 2>>& outline, int height) {
  TriMesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (const int z : {0, height}) {
    for (const auto& [x, y] : outline) {
      mesh.points.emplace_back(x, y, z);
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back({i, next, n + next});
    mesh.triangles.push_back({i, n + next, n + i});
    if (i > 0 && next != 0) {
      mesh.triangles.push_back({0, next, i});
      mesh.triangles.push_back({n, n + i, n + next});
    }
  }
  return mesh;
}

// With a square hole along it.
TriMesh tube() {
  TriMesh mesh = frame();
  for (Vec3& point : mesh.points) {
    point = Vec3(point.x() / 2 + 1.5, point.y() / 2 + 1.5, point.z() + 1);
  }
  for (Vec3& point : mesh.points) {
    point.head<2>() = point.head<2>().array().round().matrix();
  }
  return mesh;
}

}  // namespace

Solid random_grid_solid(std::mt19937& random) {
  TriMesh mesh;
  if (between(random, 0, 5) == 0) {
    mesh = tube();
  } else {
    const auto kind = static_cast<std::size_t>(between(random, 0, 5));
    mesh = prism(outlines()[kind], between(random, 1, 4));
  }
  const int axis = between(random, 0, 2);
  const int x = between(random, 0, 3), y = between(random, 0, 3), z = between(random, 0, 3);
  for (Vec3& point : mesh.points) {
    point = Vec3(point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3]) + Vec3(x, y, z);
  }
  return Solid::from(mesh);
}

}  // namespace dupin::test
