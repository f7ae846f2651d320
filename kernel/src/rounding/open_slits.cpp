#include "rounding/open_slits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include <Eigen/Geometry>

#include "arrangement/arrange.h"
#include "exact/exact_numbers.h"
#include "mesh/edge_table.h"
#include "support/blocks.h"
#include "support/sequences.h"

namespace dupin::rounding {
namespace {

/// A flat piece of surface lies within this part of a step of a plane.
constexpr double kFlat = 0.25;
/// Sheets face each other if their planes meet at less than 18 degrees.
constexpr double kFacing = -0.95;
/// Ends that were meant to meet face each other all over; pipes that rest on others, in places. So
/// much of a piece is seen to face others, by the pairs that cross once rounded, or it is no end.
constexpr double kFacingPart = 0.125;
/// Faults that one task looks at.
constexpr std::size_t kFaults = 1024;

struct Plane {
  Vec3 point, normal;  // of length 1
  [[nodiscard]] double height(const Vec3& p) const { return (p - point).dot(normal); }
  friend bool operator==(const Plane&, const Plane&) = default;
};

/// None for triangles lower than a step: they have no direction to speak of.
std::optional<Plane> plane_of(const mesh::ExactMesh& solid, std::uint32_t face, double step) {
  const Triangle& t = solid.triangles[face];
  const Vec3 &a = solid.points[t[0]], &b = solid.points[t[1]], &c = solid.points[t[2]];
  const Vec3 normal = (b - a).cross(c - a);
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  if (!(normal.norm() > step * longest)) {
    return std::nullopt;
  }
  return Plane{a, normal.normalized()};
}

/// Whether triangles with these normals show their fronts to each other.
bool are_facing(const Vec3& first, const Vec3& second) { return first.dot(second) < kFacing; }

/// A flat piece of the surface, and the planes of what it faces.
struct Patch {
  Plane plane;
  Vec3 direction;  // of the prism: near the normal, in 64ths
  std::vector<std::uint32_t> faces;
  double area = 0;
  double facing_area = 0;  ///< of what others are in front of, as far as it is known
  std::vector<Plane> facing;

  [[nodiscard]] bool is_end() const { return !facing.empty() && facing_area >= kFacingPart * area; }
};

/// The part of a polygon to the left of the line from a to b, seen against `normal`.
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, const Vec3& a, const Vec3& b,
                          const Vec3& normal) {
  const Vec3 inward = normal.cross(b - a);
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = (p - a).dot(inward), at_q = (q - a).dot(inward);
    if (at_p >= 0) {
      result.push_back(p);
    }
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
      result.emplace_back(p + at_p / (at_p - at_q) * (q - p));
    }
  }
  return result;
}

double area_of(const std::vector<Vec3>& polygon) {
  Vec3 twice = Vec3::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    twice += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
  }
  return twice.norm() / 2;
}

/// The points of prisms, each once: doubles first, as an exact mesh has them.
class PrismPoints {
 public:
  explicit PrismPoints(const mesh::ExactMesh& solid) : solid_(solid) {}

  /// A point of the solid, moved; returns a number that final() knows.
  std::uint32_t add(std::uint32_t point, const Vec3& by) {
    const auto [known, is_new] = numbers_.try_emplace({point, by.x(), by.y(), by.z()});
    if (is_new) {
      known->second = added(point, by);
    }
    return known->second;
  }

  [[nodiscard]] std::uint32_t final(std::uint32_t number) const {
    const auto doubles = static_cast<std::uint32_t>(doubles_.size());
    return number < doubles ? number : doubles + (support::kNone - 1 - number);
  }

  void take(mesh::ExactMesh& mesh) {
    mesh.points = std::move(doubles_);
    mesh.points.insert(mesh.points.end(), nearest_.begin(), nearest_.end());
    mesh.implicit = std::move(implicit_);
  }

 private:
  std::uint32_t added(std::uint32_t point, const Vec3& by) {
    const Vec3 &from = solid_.points[point], to = from + by;
    if (point < solid_.double_count() && to - from == by && to - by == from) {
      doubles_.push_back(to);
      return static_cast<std::uint32_t>(doubles_.size() - 1);
    }
    mesh::ExactPoint p = mesh::exact_point(solid_, point);
    for (int k = 0; k < 3; ++k) {
      p[k] = p[k] + CGAL::Mpzf(by[k]) * p[3];
    }
    nearest_.emplace_back(mesh::nearest_double(p[0], p[3]), mesh::nearest_double(p[1], p[3]),
                          mesh::nearest_double(p[2], p[3]));
    implicit_.push_back(std::move(p));
    return static_cast<std::uint32_t>(support::kNone - nearest_.size());
  }

  const mesh::ExactMesh& solid_;
  std::map<std::tuple<std::uint32_t, double, double, double>, std::uint32_t> numbers_;
  std::vector<Vec3> doubles_, nearest_;
  mesh::ExactPoints implicit_;
};

class OpenSlits {
 public:
  OpenSlits(const mesh::ExactMesh& solid, double step, double widest)
      : solid_(solid),
        step_(step),
        widest_(widest),
        edges_(solid.triangles, solid.points.size()),
        edge_of_(3 * solid.triangles.size()),
        patch_of_(solid.triangles.size(), support::kNone) {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      for (const std::uint32_t half_edge : edges_[i].half_edges) {
        edge_of_[half_edge] = static_cast<std::uint32_t>(i);
      }
    }
  }

  std::optional<FilledSlits> fill(std::span<const Fault> faults) {
    support::BulkVector<double> areas(faults.size());
    support::for_each_block(
        faults.size(),
        [&](const support::Block& block) {
          for (std::size_t i = block.begin; i < block.end; ++i) {
            areas[i] = area_of_slit(faults[i].first, faults[i].second);
          }
        },
        kFaults);
    for (std::size_t i = 0; i < faults.size(); ++i) {
      if (areas[i] > 0) {
        add_facing(faults[i].first, faults[i].second, areas[i]);
      }
    }
    std::erase_if(patches_, [](const Patch& patch) { return !patch.is_end(); });
    if (patches_.empty()) {
      return std::nullopt;
    }
    // Prisms may overlap, and a patch may lie over itself by some rounding of its points.
    const mesh::ExactMesh all = prisms();
    FilledSlits result;
    result.mesh = arrangement::united_with_winding(solid_, all);
    for (Source& source : result.mesh.sources) {
      source = source.operand == 0 ? solid_.sources[source.triangle] : all.sources[source.triangle];
    }
    for (const Patch& patch : patches_) {
      result.places.push_back(corner(patch.faces.front(), 0));
      for (const std::uint32_t point : points_of(patch)) {
        result.reach = std::max(result.reach, rise(patch, point) * patch.direction.norm());
      }
    }
    return result;
  }

 private:
  [[nodiscard]] const Vec3& corner(std::uint32_t face, int k) const {
    return solid_.points[solid_.triangles[face][k]];
  }

  /// Of the slit between triangles that face each other; 0 if there is none.
  [[nodiscard]] double area_of_slit(std::uint32_t f, std::uint32_t g) const {
    const auto first = plane_of(solid_, f, step_), second = plane_of(solid_, g, step_);
    return first && second && are_facing(first->normal, second->normal) ? area_of_slit(f, *first, g)
                                                                        : 0;
  }

  /// Notes that two triangles face each other across a slit of such an area.
  void add_facing(std::uint32_t f, std::uint32_t g, double area) {
    const std::uint32_t p = patch_around(f), q = patch_around(g);
    if (p == q) {
      return;
    }
    const bool extends_first = patches_[p].area <= patches_[q].area;
    Patch& extended = patches_[extends_first ? p : q];
    extended.facing_area += area;
    const Plane& met = patches_[extends_first ? q : p].plane;
    if (std::ranges::find(extended.facing, met) == extended.facing.end()) {
      extended.facing.push_back(met);
    }
  }

  /// Of where g is in front of f or behind it, if it is mostly in front, and near; else 0.
  [[nodiscard]] double area_of_slit(std::uint32_t f, const Plane& of_f, std::uint32_t g) const {
    std::vector<Vec3> common = {corner(g, 0), corner(g, 1), corner(g, 2)};
    for (int k = 0; k < 3; ++k) {
      common = clipped(common, corner(f, k), corner(f, (k + 1) % 3), of_f.normal);
    }
    double farthest = 0, sum = 0;
    for (const Vec3& p : common) {
      const double height = of_f.height(p);
      sum += height;
      farthest = std::max(farthest, std::abs(height));
    }
    return common.size() > 2 && sum > 0 && farthest <= widest_ ? area_of(common) : 0;
  }

  /// Of a triangle that has a plane.
  std::uint32_t patch_around(std::uint32_t seed) {
    if (patch_of_[seed] != support::kNone) {
      return patch_of_[seed];
    }
    const auto number = static_cast<std::uint32_t>(patches_.size());
    Patch& patch = patches_.emplace_back();
    patch.plane = plane_of(solid_, seed, step_).value();
    patch.direction = (patch.plane.normal * 64).array().round() / 64;
    patch_of_[seed] = number;
    patch.faces = {seed};
    for (std::size_t i = 0; i < patch.faces.size(); ++i) {
      const std::uint32_t face = patch.faces[i];
      const Vec3 &a = corner(face, 0), &b = corner(face, 1), &c = corner(face, 2);
      patch.area += (b - a).cross(c - a).norm() / 2;
      for (std::uint32_t h = 3 * face; h < 3 * face + 3; ++h) {
        const std::uint32_t other = across(h);
        if (other != support::kNone && patch_of_[other] == support::kNone &&
            continues(patch, other)) {
          patch_of_[other] = number;
          patch.faces.push_back(other);
        }
      }
    }
    return number;
  }

  /// The face at the other side of an edge; none where more than two meet.
  [[nodiscard]] std::uint32_t across(std::uint32_t half_edge) const {
    const auto around = edges_[edge_of_[half_edge]].half_edges;
    return around.size() != 2 ? support::kNone
                              : (around[0] == half_edge ? around[1] : around[0]) / 3;
  }

  [[nodiscard]] bool continues(const Patch& patch, std::uint32_t face) const {
    for (int k = 0; k < 3; ++k) {
      if (!(std::abs(patch.plane.height(corner(face, k))) <= kFlat * step_)) {
        return false;
      }
    }
    return is_turned_like(patch.direction, face);
  }

  /// Whether the triangle shows its front to who looks against the direction. Exact: nearest
  /// doubles do not tell how slivers are turned.
  [[nodiscard]] bool is_turned_like(const Vec3& direction, std::uint32_t face) const {
    const Vec3 &a = corner(face, 0), &b = corner(face, 1), &c = corner(face, 2);
    const double lengths = (b - a).norm() + (c - a).norm();
    const double value = (b - a).cross(c - a).dot(direction);
    // Of coordinates that are the nearest doubles, and of few operations.
    const double coordinate = 0x1p-48 * a.cwiseAbs().maxCoeff() + 0x1p-48 * lengths;
    if (std::abs(value) > coordinate * (lengths + coordinate)) {
      return value > 0;
    }
    std::array<mesh::ExactPoint, 3> p;
    for (int k = 0; k < 3; ++k) {
      p[k] = mesh::exact_point(solid_, solid_.triangles[face][k]);
    }
    const auto difference = [&](int k) {
      exact::ExactVector d;
      for (int i = 0; i < 3; ++i) {
        d[i] = p[k][i] * p[0][3] - p[0][i] * p[k][3];
      }
      return d;
    };
    return exact::sign(exact::dot(exact::cross(difference(1), difference(2)),
                                  exact::exact_vector(direction))) > 0;
  }

  [[nodiscard]] std::vector<std::uint32_t> points_of(const Patch& patch) const {
    std::vector<std::uint32_t> points;
    for (const std::uint32_t face : patch.faces) {
      points.insert(points.end(), solid_.triangles[face].begin(), solid_.triangles[face].end());
    }
    support::sort_unique(points);
    return points;
  }

  /// How far a point of the patch goes, in multiples of the direction: behind all it faces, a
  /// number with few digits.
  [[nodiscard]] double rise(const Patch& patch, std::uint32_t point) const {
    double distance = 0;
    for (const Plane& met : patch.facing) {
      distance =
          std::max(distance, met.height(solid_.points[point]) / -patch.direction.dot(met.normal));
    }
    const double unit = step_ / 16;
    return std::ceil(std::min(distance, widest_) / unit) * unit + kSlitOverlap * step_;
  }

  /// The prisms over all patches, which they share with the solid.
  [[nodiscard]] mesh::ExactMesh prisms() const {
    mesh::ExactMesh prisms;
    prisms.names = solid_.names;
    PrismPoints points(solid_);
    for (const Patch& patch : patches_) {
      add_prism(patch, points, prisms);
    }
    for (Triangle& triangle : prisms.triangles) {
      for (std::uint32_t& corner : triangle) {
        corner = points.final(corner);
      }
    }
    points.take(prisms);
    return prisms;
  }

  void add_prism(const Patch& patch, PrismPoints& points, mesh::ExactMesh& prisms) const {
    std::map<std::uint32_t, std::uint32_t> low, high;
    for (const std::uint32_t point : points_of(patch)) {
      low[point] = points.add(point, Vec3::Zero());
      high[point] = points.add(point, rise(patch, point) * patch.direction);
    }
    const auto put = [&](std::uint32_t face, const Triangle& triangle) {
      prisms.triangles.push_back(triangle);
      prisms.sources.push_back(solid_.sources[face]);
      if (!solid_.labels.empty()) {
        prisms.labels.push_back(solid_.labels[face]);
      }
    };
    const std::uint32_t number = patch_of_[patch.faces.front()];
    for (const std::uint32_t face : patch.faces) {
      const Triangle& t = solid_.triangles[face];
      put(face, {low[t[0]], low[t[2]], low[t[1]]});
      put(face, {high[t[0]], high[t[1]], high[t[2]]});
      for (std::uint32_t h = 3 * face; h < 3 * face + 3; ++h) {
        const std::uint32_t other = across(h);
        if (other == support::kNone || patch_of_[other] != number) {
          const std::uint32_t a = edges_.origin(h), b = edges_.target(h);
          put(face, {low[a], low[b], high[b]});
          put(face, {low[a], high[b], high[a]});
        }
      }
    }
  }

  const mesh::ExactMesh& solid_;
  double step_, widest_;
  mesh::EdgeTable edges_;
  std::vector<std::uint32_t> edge_of_, patch_of_;
  std::vector<Patch> patches_;
};

}  // namespace

FacingTriangles::FacingTriangles(const mesh::ExactMesh& solid, double step)
    : normals_(solid.triangles.size()) {
  support::for_each_block(normals_.size(), [&](const support::Block& block) {
    for (auto f = static_cast<std::uint32_t>(block.begin); f < block.end; ++f) {
      const auto plane = plane_of(solid, f, step);
      normals_[f] = plane ? plane->normal : Vec3(Vec3::Zero());
    }
  });
}

bool FacingTriangles::operator()(std::uint32_t first, std::uint32_t second) const {
  return are_facing(normals_[first], normals_[second]);
}

std::optional<FilledSlits> fill_open_slits(const mesh::ExactMesh& solid,
                                           std::span<const Fault> faults, double step,
                                           double widest) {
  return OpenSlits(solid, step, widest).fill(faults);
}

}  // namespace dupin::rounding
