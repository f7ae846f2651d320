#pragma once

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/blends/junction.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/solid.h"
#include "junction/hub_mesh.h"
#include "numbers/point_order.h"

namespace dupin::test {

struct JunctionMesh {
  TriMesh open, closed;  // without and with the ends' discs
  Tessellation hub;
  double error_bound = 0;
};

// Points at the same place are the same.
class Welder {
 public:
  void append(const TriMesh& mesh) {
    for (const Triangle& t : mesh.triangles) {
      Triangle own{};
      for (std::size_t i = 0; i < 3; ++i) {
        own.at(i) = vertex(mesh.points[t.at(i)]);
      }
      mesh_.triangles.push_back(own);
    }
  }
  [[nodiscard]] const TriMesh& mesh() const { return mesh_; }

 private:
  std::uint32_t vertex(const Vec3& point) {
    const auto [entry, is_new] = at_.try_emplace(point, std::uint32_t(mesh_.points.size()));
    if (is_new) {
      mesh_.points.push_back(point);
    }
    return entry->second;
  }
  std::map<Vec3, std::uint32_t, numbers::PointOrder> at_;
  TriMesh mesh_;
};

inline JunctionMesh mesh_of(const Junction& junction, double tolerance, double grid) {
  std::uint32_t segments = 8;
  for (const JunctionArm& arm : junction.arms) {
    segments = std::max(segments, segments_for(tube(arm), 0.7 * tolerance, grid));
  }
  JunctionMesh result;
  Welder welder;
  std::vector<std::vector<Vec3>> circles;
  for (std::size_t i = 0; i < junction.arms.size(); ++i) {
    const RingSampling sampling{segments, 0.37 * double(i), grid};
    const Tessellation arm = tessellate(tube(junction.arms[i]), sampling, {tolerance});
    welder.append(arm.mesh);
    result.error_bound = std::max(result.error_bound, arm.error_bound);
    circles.push_back(sample(cap_circle(junction.arms[i]), sampling));
  }
  result.hub = junction::hub_mesh(junction, circles, {tolerance, grid});
  result.error_bound = std::max(result.error_bound, result.hub.error_bound);
  welder.append(result.hub.mesh);
  result.open = welder.mesh();
  for (std::size_t i = 0; i < junction.arms.size(); ++i) {
    welder.append(end_cap_mesh(flipped(junction.arms[i].end), {segments, 0.37 * double(i), grid}));
  }
  result.closed = welder.mesh();
  return result;
}

// Points less edges and triangles.
inline int euler_number(const TriMesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      edges.insert(std::minmax(t.at(i), t.at((i + 1) % 3)));
    }
  }
  return int(mesh.points.size()) - int(edges.size()) + int(mesh.triangles.size());
}

inline Vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Vec3 result;
  do {
    result = Vec3(normal(random), normal(random), normal(random));
  } while (result.norm() < 1e-3);
  return result.normalized();
}

// Pipes and cones of various radii from all directions, their axes through one place or past it by
// less than a radius, some too near.
inline std::vector<Ring> random_ends(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> unit(0, 1);
  const Vec3 center = 20 * random_direction(random);
  const bool meet = unit(random) < 0.5;
  const double near = unit(random) < 0.2 ? 1 : 4;
  std::vector<Ring> ends;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 direction = random_direction(random);
    const double radius = 0.2 + 0.8 * unit(random), distance = near + 12 * unit(random);
    const double off = meet ? 0 : unit(random) * radius;
    const Vec3 normal = (-distance * direction + off * random_direction(random)).normalized();
    const double slope = unit(random) < 0.7 ? 0 : 0.1 * (unit(random) - 0.5);
    ends.push_back({center + distance * direction, normal, radius, slope});
  }
  return ends;
}

}  // namespace dupin::test
