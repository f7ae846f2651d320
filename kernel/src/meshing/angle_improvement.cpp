#include "meshing/angle_improvement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "meshing/delaunay_refinement.h"

namespace dupin::meshing {
namespace {

constexpr int kRounds = 12;
/// Angles are made a little larger than wanted, for what is moved beside them later.
constexpr double kMore = 1.04;
/// A move has to gain so much, in radians.
constexpr double kGain = 1e-6;

/// What is at each point: items of `corners` that have it.
template <class Item>
class Incidence {
 public:
  Incidence(const std::vector<Item>& items, std::size_t points) : starts_(points + 1, 0) {
    for (const Item& item : items) {
      for (const std::uint32_t v : item) {
        ++starts_[v + 1];
      }
    }
    for (std::size_t v = 0; v < points; ++v) {
      starts_[v + 1] += starts_[v];
    }
    items_.resize(starts_.back());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t i = 0; i < items.size(); ++i) {
      for (const std::uint32_t v : items[i]) {
        items_[next[v]++] = i;
      }
    }
  }
  [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t point) const {
    return std::span(items_).subspan(starts_[point], starts_[point + 1] - starts_[point]);
  }

 private:
  std::vector<std::uint32_t> starts_, items_;
};

class Improvement {
 public:
  Improvement(Tetrahedra& mesh, const ReferenceSurface& surface, double wanted)
      : mesh_(mesh),
        surface_(surface),
        wanted_(wanted * kMore),
        triangles_(mesh.triangles, mesh.points.size()),
        tetrahedra_(mesh.tetrahedra, mesh.points.size()) {}

  void run() {
    for (int round = 0; round < kRounds; ++round) {
      std::size_t moved = 0;
      for (const std::uint32_t v : points_near_poor()) {
        moved += improve(v) ? 1 : 0;
      }
      if (moved == 0) {
        break;
      }
    }
  }

 private:
  [[nodiscard]] double angle_of(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    return smallest_angle(mesh_.points[a], mesh_.points[b], mesh_.points[c]);
  }
  [[nodiscard]] double angle_around(std::uint32_t point) const {
    double least = wanted_;
    for (const std::uint32_t f : triangles_.at(point)) {
      least = std::min(least, angle_of(f));
    }
    return least;
  }
  [[nodiscard]] bool is_valid_around(std::uint32_t point) const {
    return std::ranges::all_of(tetrahedra_.at(point), [&](std::uint32_t t) {
      const auto& [a, b, c, d] = mesh_.tetrahedra[t];
      return is_positive(mesh_.points[a], mesh_.points[b], mesh_.points[c], mesh_.points[d]);
    });
  }

  /// Those of triangles with an angle below the bound, and of their neighbours.
  [[nodiscard]] std::vector<std::uint32_t> points_near_poor() const {
    std::vector<std::uint32_t> points;
    for (std::uint32_t f = 0; f < mesh_.triangles.size(); ++f) {
      if (angle_of(f) >= wanted_) {
        continue;
      }
      for (const std::uint32_t v : mesh_.triangles[f]) {
        for (const std::uint32_t g : triangles_.at(v)) {
          std::ranges::copy_if(mesh_.triangles[g], std::back_inserter(points),
                               [&](std::uint32_t w) { return mesh_.may_move[w] != 0; });
        }
      }
    }
    std::ranges::sort(points);
    const auto same = std::ranges::unique(points);
    points.erase(same.begin(), same.end());
    return points;
  }

  /// Looks for a better place in eight directions, in steps that get shorter.
  bool improve(std::uint32_t v) {
    const std::span<const std::uint32_t> around = triangles_.at(v);
    const Vec3 before = mesh_.points[v];
    double best = angle_around(v), reach = 0;
    if (best >= wanted_) {
      return false;
    }
    Vec3 normal = Vec3::Zero();
    for (const std::uint32_t f : around) {
      const auto& [a, b, c] = mesh_.triangles[f];
      normal += (mesh_.points[b] - mesh_.points[a]).cross(mesh_.points[c] - mesh_.points[a]);
      for (const std::uint32_t w : mesh_.triangles[f]) {
        reach = std::max(reach, (mesh_.points[w] - before).norm());
      }
    }
    const Vec3 across = normal.unitOrthogonal(), along = normal.normalized().cross(across);
    Vec3 place = before;
    constexpr int kDirections = 8;
    for (double step = reach / 4; step > reach / 200 && best < wanted_;) {
      const Vec3 centre = place;
      for (int k = 0; k < kDirections; ++k) {
        const double turn = 2 * std::numbers::pi * k / kDirections;
        const auto there =
            surface_.nearest(centre + step * (std::cos(turn) * across + std::sin(turn) * along),
                             mesh_.regions[around.front()], 2 * step);
        if (!there || (there->point - before).norm() > reach) {
          continue;
        }
        mesh_.points[v] = there->point;
        const double angle = angle_around(v);
        if (angle > best + kGain && is_valid_around(v)) {
          best = angle;
          place = there->point;
        }
      }
      step = place == centre ? step / 2 : step;
    }
    mesh_.points[v] = place;
    return place != before;
  }

  Tetrahedra& mesh_;
  const ReferenceSurface& surface_;
  double wanted_;
  Incidence<Triangle> triangles_;
  Incidence<Tetrahedron> tetrahedra_;
};

}  // namespace

double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto at = [](const Vec3& p, const Vec3& q, const Vec3& r) {
    const Vec3 u = q - p, v = r - p;
    return std::atan2(u.cross(v).norm(), u.dot(v));
  };
  return std::min({at(a, b, c), at(b, c, a), at(c, a, b)});
}

void improve_angles(Tetrahedra& mesh, const ReferenceSurface& surface, double wanted) {
  Improvement(mesh, surface, wanted).run();
}

}  // namespace dupin::meshing
