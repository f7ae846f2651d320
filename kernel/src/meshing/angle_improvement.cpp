#include "meshing/angle_improvement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "meshing/incidence.h"

namespace dupin::meshing {
namespace {

constexpr int kRounds = 12;
/// Angles are made a little larger than wanted, for what is moved beside them later, and larger
/// still where that is not enough: neighbours that are good enough make room.
constexpr double kMore = 1.04, kMuchMore = 1.4;
/// A move has to gain so much, in radians.
constexpr double kGain = 1e-6;

/// What is about each point of a mesh, and how good it is.
class Stars {
 public:
  explicit Stars(Tetrahedra& mesh)
      : mesh_(mesh),
        triangles_(mesh.triangles, mesh.points.size()),
        tetrahedra_(mesh.tetrahedra, mesh.points.size()) {}

  [[nodiscard]] double angle_of(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    return smallest_angle(mesh_.points[a], mesh_.points[b], mesh_.points[c]);
  }
  [[nodiscard]] double dihedral_angle_of(std::uint32_t tetrahedron) const {
    const auto& [a, b, c, d] = mesh_.tetrahedra[tetrahedron];
    return smallest_dihedral_angle(
        {mesh_.points[a], mesh_.points[b], mesh_.points[c], mesh_.points[d]});
  }
  /// The smallest about a point, or `enough`, if all are larger; the first one that is not above
  /// `floor`, if one is not.
  [[nodiscard]] double angle_around(std::uint32_t point, double enough, double floor = 0) const {
    return least_of(triangles_.at(point), enough, floor,
                    [this](std::uint32_t f) { return angle_of(f); });
  }
  [[nodiscard]] double dihedral_angle_around(std::uint32_t point, double enough,
                                             double floor = 0) const {
    return least_of(tetrahedra_.at(point), enough, floor,
                    [this](std::uint32_t t) { return dihedral_angle_of(t); });
  }
  [[nodiscard]] bool is_valid_around(std::uint32_t point) const {
    return std::ranges::all_of(tetrahedra_.at(point), [&](std::uint32_t t) {
      const auto& [a, b, c, d] = mesh_.tetrahedra[t];
      return is_positive(mesh_.points[a], mesh_.points[b], mesh_.points[c], mesh_.points[d]);
    });
  }
  /// The way to the furthest neighbour.
  [[nodiscard]] double reach(std::uint32_t point) const {
    double reach = 0;
    const auto look = [&](const auto& corners) {
      for (const std::uint32_t w : corners) {
        reach = std::max(reach, (mesh_.points[w] - mesh_.points[point]).norm());
      }
    };
    for (const std::uint32_t f : triangles_.at(point)) {
      look(mesh_.triangles[f]);
    }
    for (const std::uint32_t t : tetrahedra_.at(point)) {
      look(mesh_.tetrahedra[t]);
    }
    return reach;
  }
  /// Of the triangles about a point, as long as twice their areas.
  [[nodiscard]] std::vector<Vec3> normals(std::uint32_t point) const {
    std::vector<Vec3> normals;
    for (const std::uint32_t f : triangles_.at(point)) {
      const auto& [a, b, c] = mesh_.triangles[f];
      normals.emplace_back(
          (mesh_.points[b] - mesh_.points[a]).cross(mesh_.points[c] - mesh_.points[a]));
    }
    return normals;
  }
  [[nodiscard]] Vec3 normal(std::uint32_t point) const {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& normal : normals(point)) {
      sum += normal;
    }
    return sum;
  }
  [[nodiscard]] const Incidence<Triangle>& triangles() const { return triangles_; }

 private:
  template <class Angle>
  [[nodiscard]] static double least_of(std::span<const std::uint32_t> about, double enough,
                                       double floor, const Angle& angle) {
    double least = enough;
    for (std::size_t i = 0; i < about.size() && least > floor; ++i) {
      least = std::min(least, angle(about[i]));
    }
    return least;
  }

  Tetrahedra& mesh_;
  Incidence<Triangle> triangles_;
  Incidence<Tetrahedron> tetrahedra_;
};

/// Looks for better places of single points, by steps in some directions that get shorter.
class Search {
 public:
  Search(Tetrahedra& mesh, const mesh::ReferenceSurface& surface, const Stars& stars,
         const MoveLimits& limits)
      : mesh_(mesh), surface_(surface), stars_(stars), limits_(limits) {}

  /// Whether the point has moved. `quality(v, floor)` is to become larger, `enough` at most, and
  /// may be anything up to `floor` where it is no more than that; `is_allowed` is asked for places
  /// where it does.
  template <class Quality, class Allowed>
  bool improve(std::uint32_t v, double enough, const Quality& quality, const Allowed& is_allowed) {
    const Vec3 before = mesh_.points[v];
    double best = quality(v, 0);
    if (best >= enough) {
      return false;
    }
    const double reach = stars_.reach(v);
    const std::vector<Vec3> directions = directions_of(v), normals = stars_.normals(v);
    Vec3 place = before;
    for (double step = reach / 4; step > reach / 200 && best < enough;) {
      const Vec3 centre = place;
      for (const Vec3& direction : directions) {
        const auto there = moved(v, centre + step * direction, 2 * step);
        if (!there || (*there - before).norm() > reach) {
          continue;
        }
        mesh_.points[v] = *there;
        if (const double now = quality(v, best + kGain);
            now > best + kGain && stars_.reach(v) <= std::max(reach, limits_.longest_edge) &&
            keeps_sides(v, normals) && stays_near(v) && is_allowed(v) &&
            stars_.is_valid_around(v)) {
          best = now;
          place = *there;
        }
      }
      step = place == centre ? step / 2 : step;
    }
    mesh_.points[v] = place;
    return place != before;
  }

 private:
  /// Unit vectors: eight along the surface, or 14 in space.
  [[nodiscard]] std::vector<Vec3> directions_of(std::uint32_t v) const {
    std::vector<Vec3> directions;
    if (mesh_.freedoms[v] == Freedom::region) {
      constexpr int kDirections = 8;
      const Vec3 normal = stars_.normal(v), across = normal.unitOrthogonal(),
                 along = normal.normalized().cross(across);
      for (int k = 0; k < kDirections; ++k) {
        const double turn = 2 * std::numbers::pi * k / kDirections;
        directions.emplace_back(std::cos(turn) * across + std::sin(turn) * along);
      }
      return directions;
    }
    for (const double x : {-1.0, 0.0, 1.0}) {
      for (const double y : {-1.0, 0.0, 1.0}) {
        for (const double z : {-1.0, 0.0, 1.0}) {
          const double sum = std::abs(x) + std::abs(y) + std::abs(z);
          if (sum == 1 || sum == 3) {
            directions.push_back(Vec3(x, y, z).normalized());
          }
        }
      }
    }
    return directions;
  }
  /// Whether triangles about a point look as they did, within a right angle.
  [[nodiscard]] bool keeps_sides(std::uint32_t v, const std::vector<Vec3>& normals) const {
    const std::vector<Vec3> now = stars_.normals(v);
    return std::ranges::equal(now, normals,
                              [](const Vec3& a, const Vec3& b) { return a.dot(b) > 0; });
  }
  [[nodiscard]] bool stays_near(std::uint32_t v) const {
    return std::ranges::all_of(stars_.triangles().at(v), [&](std::uint32_t f) {
      const auto& [a, b, c] = mesh_.triangles[f];
      return surface_.looks_near({mesh_.points[a], mesh_.points[b], mesh_.points[c]},
                                 mesh_.regions[f], limits_.distance);
    });
  }
  [[nodiscard]] std::optional<Vec3> moved(std::uint32_t v, const Vec3& to, double reach) const {
    if (mesh_.freedoms[v] == Freedom::inside) {
      return to;
    }
    const std::uint32_t face = stars_.triangles().at(v).front();
    const auto there = surface_.nearest(to, mesh_.regions[face], reach);
    return there ? std::optional(there->point) : std::nullopt;
  }

  Tetrahedra& mesh_;
  const mesh::ReferenceSurface& surface_;
  const Stars& stars_;
  const MoveLimits& limits_;
};

void sort_unique(std::vector<std::uint32_t>& numbers) {
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// Points in regions of triangles with a smaller angle, and of their neighbours.
std::vector<std::uint32_t> points_near_poor_triangles(const Tetrahedra& mesh, const Stars& stars,
                                                      double wanted) {
  std::vector<std::uint32_t> points;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    if (stars.angle_of(f) >= wanted) {
      continue;
    }
    for (const std::uint32_t v : mesh.triangles[f]) {
      for (const std::uint32_t g : stars.triangles().at(v)) {
        std::ranges::copy_if(mesh.triangles[g], std::back_inserter(points),
                             [&](std::uint32_t w) { return mesh.freedoms[w] == Freedom::region; });
      }
    }
  }
  sort_unique(points);
  return points;
}

/// Points of tetrahedra with a smaller dihedral angle that may move.
std::vector<std::uint32_t> points_of_slivers(const Tetrahedra& mesh, const Stars& stars,
                                             double wanted) {
  std::vector<std::uint32_t> points;
  for (std::uint32_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    if (stars.dihedral_angle_of(t) < wanted) {
      std::ranges::copy_if(mesh.tetrahedra[t], std::back_inserter(points),
                           [&](std::uint32_t v) { return mesh.freedoms[v] != Freedom::none; });
    }
  }
  sort_unique(points);
  return points;
}

/// Improves the points that are asked for anew each round, until none moves any more.
template <class Points, class Improve>
void in_rounds(const Points& points, const Improve& improve) {
  for (int round = 0; round < kRounds; ++round) {
    bool moved = false;
    for (const std::uint32_t v : points()) {
      moved = improve(v) || moved;
    }
    if (!moved) {
      break;
    }
  }
}

}  // namespace

double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  // Opposite to the shortest side; 0.0 - 0.0 has no sign.
  const Vec3 u = b - a, v = c - b, w = a - c;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), ww = w.squaredNorm();
  const double dot = uu <= vv && uu <= ww ? v.dot(w) : vv <= ww ? w.dot(u) : u.dot(v);
  return std::atan2(u.cross(v).norm(), 0.0 - dot);
}

double smallest_dihedral_angle(const std::array<Vec3, 4>& corners) {
  std::array<Vec3, 4> normals;
  std::ranges::transform(faces_of({0, 1, 2, 3}), normals.begin(), [&](const Triangle& face) {
    const Vec3& a = corners[face[0]];
    return Vec3((corners[face[1]] - a).cross(corners[face[2]] - a));
  });
  double least = std::numbers::pi;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double sine = normals[i].cross(normals[k]).norm();
      least = std::min(least, std::atan2(sine, -normals[i].dot(normals[k])));
    }
  }
  return least;
}

void improve_angles(Tetrahedra& mesh, const mesh::ReferenceSurface& surface, double wanted,
                    const MoveLimits& limits) {
  const Stars stars(mesh);
  Search search(mesh, surface, stars, limits);
  const auto improve = [&](double poor, double enough) {
    in_rounds(
        [&] { return points_near_poor_triangles(mesh, stars, poor); },
        [&](std::uint32_t v) {
          return search.improve(
              v, enough,
              [&](std::uint32_t w, double floor) { return stars.angle_around(w, enough, floor); },
              [](std::uint32_t) { return true; });
        });
  };
  improve(wanted * kMore, wanted * kMore);
  improve(wanted, wanted * kMuchMore);
}

void improve_dihedral_angles(Tetrahedra& mesh, const mesh::ReferenceSurface& surface, double wanted,
                             double wanted_of_triangles, const MoveLimits& limits) {
  const Stars stars(mesh);
  Search search(mesh, surface, stars, limits);
  const double enough = wanted * kMore;
  in_rounds(
      [&] { return points_of_slivers(mesh, stars, wanted); },
      [&](std::uint32_t v) {
        const double kept = stars.angle_around(v, wanted_of_triangles);
        return search.improve(
            v, enough,
            [&](std::uint32_t w, double floor) {
              return stars.dihedral_angle_around(w, enough, floor);
            },
            [&](std::uint32_t w) { return stars.angle_around(w, wanted_of_triangles) >= kept; });
      });
}

}  // namespace dupin::meshing
