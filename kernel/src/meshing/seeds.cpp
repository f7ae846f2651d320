#include "meshing/seeds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include <Eigen/Geometry>

#include "support/none.h"

namespace dupin::meshing {
namespace {

class Sower {
 public:
  Sower(const TriMesh& mesh, const Features& features, const mesh::ReferenceSurface& surface)
      : mesh_(mesh), features_(features), surface_(surface) {
    has_curve_.assign(1 + static_cast<std::size_t>(*std::ranges::max_element(features.regions)), 0);
    for (const Curve& curve : features.curves) {
      has_curve_[curve.regions[0]] = has_curve_[curve.regions[1]] = 1;
    }
  }

  std::vector<Seed> run(const EdgeLengths& lengths) {
    add_triangles(lengths);
    add_extreme_points();
    return std::move(seeds_);
  }

 private:
  void add_triangles(const EdgeLengths& lengths) {
    std::vector<std::uint32_t> largest(has_curve_.size(), support::kNone);
    std::vector<double> areas(has_curve_.size(), -1);
    for (std::uint32_t f = 0; f < mesh_.triangles.size(); ++f) {
      const auto& [a, b, c] = surface_.corners(f);
      const double area = (b - a).cross(c - a).norm();
      if (const std::uint32_t region = features_.regions[f]; area > areas[region]) {
        areas[region] = area;
        largest[region] = f;
      }
    }
    constexpr double kShare = 0.3;  // of the length of edges
    for (std::uint32_t region = 0; region < has_curve_.size(); ++region) {
      const auto& [a, b, c] = surface_.corners(largest[region]);
      const Vec3 middle = (a + b + c) / 3, normal = features_.normals[largest[region]];
      const Vec3 across = normal.unitOrthogonal(), along = normal.cross(across);
      const double step = kShare * lengths.at(middle);
      for (int k = 0; k < 3; ++k) {
        const double turn = 2 * std::numbers::pi * k / 3;
        const auto near = surface_.nearest(
            middle + step * (std::cos(turn) * across + std::sin(turn) * along), region, 2 * step);
        if (near) {
          seeds_.push_back({near->point, region, has_curve_[region] == 0});
        }
      }
    }
  }

  /// With three points near each other alone there would be no tetrahedron.
  void add_extreme_points() {
    constexpr std::size_t kDirections = 6;
    std::vector<std::array<std::uint32_t, kDirections>> extremes(has_curve_.size());
    std::ranges::for_each(extremes, [](auto& points) { points.fill(support::kNone); });
    const auto reach = [&](std::uint32_t v, std::size_t k) {
      const double coordinate = mesh_.points[v][static_cast<Eigen::Index>(k / 2)];
      return k % 2 == 0 ? coordinate : -coordinate;
    };
    for (std::uint32_t f = 0; f < mesh_.triangles.size(); ++f) {
      for (const std::uint32_t v : mesh_.triangles[f]) {
        for (std::size_t k = 0; k < kDirections; ++k) {
          std::uint32_t& extreme = extremes[features_.regions[f]][k];
          if (extreme == support::kNone || reach(v, k) > reach(extreme, k)) {
            extreme = v;
          }
        }
      }
    }
    for (std::uint32_t region = 0; region < extremes.size(); ++region) {
      for (const std::uint32_t v : extremes[region]) {
        seeds_.push_back({mesh_.points[v], region, has_curve_[region] == 0});
      }
    }
  }

  const TriMesh& mesh_;
  const Features& features_;
  const mesh::ReferenceSurface& surface_;
  std::vector<std::uint8_t> has_curve_;  // per region
  std::vector<Seed> seeds_;
};

}  // namespace

std::vector<Seed> seeds_of(const TriMesh& mesh, const Features& features,
                           const mesh::ReferenceSurface& surface, const EdgeLengths& lengths) {
  return Sower(mesh, features, surface).run(lengths);
}

}  // namespace dupin::meshing
