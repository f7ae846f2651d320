#include "support/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dupin::test {

TriMesh box(const Vec3& low, const Vec3& high) {
  TriMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.points.emplace_back((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                             (i & 4) != 0 ? high.z() : low.z());
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriMesh tetrahedron(const Vec3& offset, double size) {
  TriMesh mesh;
  mesh.points = {offset, offset + size * Vec3::UnitX(), offset + size * Vec3::UnitY(),
                 offset + size * Vec3::UnitZ()};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

TriMesh frame() {
  TriMesh mesh;
  const std::array<Vec3, 4> corners = {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0),
                                       Vec3(-1, 1, 0)};
  // Rings of four points: outer low, outer high, inner high, inner low.
  for (const auto& [size, height] : {std::pair(3, -1), {3, 1}, {1, 1}, {1, -1}}) {
    for (const Vec3& corner : corners) {
      mesh.points.push_back(size * corner + height * Vec3::UnitZ());
    }
  }
  for (std::uint32_t ring = 0; ring < 4; ++ring) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t next = (i + 1) % 4, a = 4 * ring, b = 4 * ((ring + 1) % 4);
      mesh.triangles.push_back({a + i, a + next, b + next});
      mesh.triangles.push_back({a + i, b + next, b + i});
    }
  }
  return mesh;
}

TriMesh tube(double radius, double low, double high, std::uint32_t segments) {
  TriMesh mesh;
  for (const double height : {low, high}) {
    for (std::uint32_t i = 0; i < segments; ++i) {
      const double angle = 2 * std::numbers::pi * i / segments;
      mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
  }
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t next = (i + 1) % segments;
    mesh.triangles.push_back({i, next, segments + next});
    mesh.triangles.push_back({i, segments + next, segments + i});
    if (i > 0 && i + 1 < segments) {
      mesh.triangles.push_back({0, i + 1, i});
      mesh.triangles.push_back({segments, segments + i, segments + i + 1});
    }
  }
  return mesh;
}

std::vector<TriMesh> pyramids(const std::array<double, 4>& heights) {
  TriMesh low;
  low.points = {{0, 0, heights[0]}, {1, 0, heights[1]}, {1, 1, heights[2]}, {0, 1, heights[3]}};
  TriMesh high = low;
  low.points.emplace_back(0.5, 0.5, -1);
  low.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}};
  high.points.emplace_back(0.5, 0.5, 2);
  high.triangles = {{0, 3, 1}, {1, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return {low, high};
}

TriMesh joined(const std::vector<TriMesh>& meshes) {
  TriMesh result;
  for (const TriMesh& mesh : meshes) {
    const auto first_point = static_cast<std::uint32_t>(result.points.size());
    const auto first_name = static_cast<std::uint32_t>(result.names.size());
    result.points.insert(result.points.end(), mesh.points.begin(), mesh.points.end());
    for (const Triangle& t : mesh.triangles) {
      result.triangles.push_back({t[0] + first_point, t[1] + first_point, t[2] + first_point});
    }
    for (const std::uint32_t label : mesh.labels) {
      result.labels.push_back(label + first_name);
    }
    result.names.insert(result.names.end(), mesh.names.begin(), mesh.names.end());
  }
  return result;
}

TriMesh cut_otherwise(TriMesh box) {
  double low = box.points[0].x(), high = low;
  for (const Vec3& point : box.points) {
    low = std::min(low, point.x());
    high = std::max(high, point.x());
  }
  for (Vec3& point : box.points) {
    point.x() = low + high - point.x();
  }
  return reversed(std::move(box));
}

TriMesh reversed(TriMesh mesh) {
  for (Triangle& corners : mesh.triangles) {
    std::swap(corners[1], corners[2]);
  }
  return mesh;
}

TriMesh moved(TriMesh mesh, const Vec3& by) {
  for (Vec3& point : mesh.points) {
    point += by;
  }
  return mesh;
}

TriMesh labelled(TriMesh mesh, const std::string& name) {
  mesh.labels.assign(mesh.triangles.size(), 0);
  mesh.names = {name};
  return mesh;
}

}  // namespace dupin::test
