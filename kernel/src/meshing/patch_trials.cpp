#include "meshing/patch_trials.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "meshing/edge_edits.h"
#include "meshing/incidence.h"

namespace dupin::meshing {
namespace {

constexpr int kRounds = 4;
/// Triangles about the poor one, in rings of neighbours.
constexpr int kRings = 2;
/// Of patches tried: so many, and a share of the triangles.
constexpr std::size_t kMostPatches = 16, kTrianglesPerPatch = 500;
/// What comes of a trial has to gain so much, in radians.
constexpr double kGain = 1e-4;

/// Some triangles of a mesh as a mesh of their own.
struct Patch {
  std::vector<std::uint32_t> faces;
  std::vector<std::uint32_t> points;  ///< of the whole, those that stay first
  std::size_t kept = 0;               ///< how many stay
  Tetrahedra mesh;
  std::map<Edge, int> sides;        ///< of each edge that stays, how many triangles have it
  std::vector<BorderChain> chains;  ///< these edges
  std::set<Edge> curves;            ///< those of them that are of the chains of the whole
};

double smallest_angle_of(const Tetrahedra& mesh, const Triangle& t) {
  return smallest_angle(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
}

/// Whether the smallest angle of a triangle is between two edges of curves.
bool is_excused(const Tetrahedra& mesh, const Triangle& t, const std::set<Edge>& curves) {
  std::array<double, 3> lengths{};
  for (std::size_t k = 0; k < 3; ++k) {
    lengths[k] = (mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]]).norm();
  }
  const auto shortest =
      static_cast<std::size_t>(std::ranges::min_element(lengths) - lengths.begin());
  const std::uint32_t tip = t[(shortest + 2) % 3];
  return curves.contains(edge_of(tip, t[shortest])) &&
         curves.contains(edge_of(tip, t[(shortest + 1) % 3]));
}

/// The smallest angle of triangles, without those that are excused.
double quality_of(const Tetrahedra& mesh, const std::set<Edge>& curves) {
  double least = std::numbers::pi;
  for (const Triangle& t : mesh.triangles) {
    if (!is_excused(mesh, t, curves)) {
      least = std::min(least, smallest_angle_of(mesh, t));
    }
  }
  return least;
}

/// Patches of one round, no two of which have a point in common.
class Round {
 public:
  Round(Tetrahedra& mesh, const mesh::ReferenceSurface& surface, const std::set<Edge>& curves,
        double wanted, const MoveLimits& limits)
      : mesh_(mesh),
        surface_(surface),
        curves_(curves),
        wanted_(wanted),
        limits_(limits),
        at_(mesh.triangles, mesh.points.size()),
        is_changed_(mesh.points.size(), 0),
        is_gone_(mesh.triangles.size(), 0) {}

  /// Tries `left` patches at most, and counts them off.
  bool run(std::size_t& left) {
    const auto count = static_cast<std::uint32_t>(mesh_.triangles.size());
    bool has_changed = false;
    for (std::uint32_t f = 0; f < count && left > 0; ++f) {
      if (is_gone_[f] == 0 && is_poor(mesh_.triangles[f])) {
        --left;
        has_changed = improve(f) || has_changed;
      }
    }
    if (has_changed) {
      is_gone_.resize(mesh_.triangles.size(), 0);
      take_away(mesh_, is_gone_);
    }
    return has_changed;
  }

 private:
  [[nodiscard]] bool is_poor(const Triangle& t) const {
    return smallest_angle_of(mesh_, t) < wanted_ && !is_excused(mesh_, t, curves_);
  }

  bool improve(std::uint32_t f) {
    const std::optional<Patch> patch = patch_about(f);
    if (!patch) {
      return false;
    }
    double best = quality_of(patch->mesh, patch->curves) + kGain;
    std::optional<Tetrahedra> better;
    for_each_trial(*patch, [&](Tetrahedra trial) {
      improve_angles(trial, surface_, wanted_, limits_);
      if (edit_edges(trial, surface_, patch->chains, wanted_, limits_)) {
        improve_angles(trial, surface_, wanted_, limits_);
      }
      const double quality = quality_of(trial, patch->curves);
      if (quality > best && fits(trial, *patch)) {
        best = quality;
        better = std::move(trial);
      }
      return best < wanted_;
    });
    if (better) {
      put(*better, *patch);
    }
    return better.has_value();
  }

  [[nodiscard]] std::optional<Patch> patch_about(std::uint32_t f) const {
    Patch patch;
    std::set<std::uint32_t> faces = {f}, points;
    for (int ring = 0; ring < kRings; ++ring) {
      for (const std::uint32_t g : std::set(faces)) {
        for (const std::uint32_t v : mesh_.triangles[g]) {
          faces.insert(at_.at(v).begin(), at_.at(v).end());
        }
      }
    }
    for (const std::uint32_t g : faces) {
      points.insert(mesh_.triangles[g].begin(), mesh_.triangles[g].end());
    }
    if (std::ranges::any_of(points, [&](std::uint32_t v) { return is_changed_[v] != 0; })) {
      return std::nullopt;
    }
    patch.faces.assign(faces.begin(), faces.end());
    patch.points.assign(points.begin(), points.end());
    const auto is_kept = [&](std::uint32_t v) {
      return mesh_.freedoms[v] != Freedom::region ||
             std::ranges::any_of(at_.at(v), [&](std::uint32_t g) { return !faces.contains(g); });
    };
    const auto middle = std::stable_partition(patch.points.begin(), patch.points.end(), is_kept);
    patch.kept = static_cast<std::size_t>(middle - patch.points.begin());
    fill(patch);
    return patch;
  }

  void fill(Patch& patch) const {
    std::map<std::uint32_t, std::uint32_t> numbers;
    for (const std::uint32_t v : patch.points) {
      const bool stays = numbers.size() < patch.kept;
      numbers.emplace(v, static_cast<std::uint32_t>(numbers.size()));
      patch.mesh.points.push_back(mesh_.points[v]);
      patch.mesh.freedoms.push_back(stays ? Freedom::none : Freedom::region);
    }
    std::map<Edge, int> sides;
    for (const std::uint32_t g : patch.faces) {
      const auto& [a, b, c] = mesh_.triangles[g];
      const Triangle t = {numbers[a], numbers[b], numbers[c]};
      patch.mesh.triangles.push_back(t);
      patch.mesh.regions.push_back(mesh_.regions[g]);
      for (std::size_t k = 0; k < 3; ++k) {
        ++sides[edge_of(t[k], t[(k + 1) % 3])];
      }
    }
    for (const auto& [edge, count] : sides) {
      const bool is_curve =
          curves_.contains(edge_of(patch.points[edge.first], patch.points[edge.second]));
      if (is_curve) {
        patch.curves.insert(edge);
      }
      if (is_curve || count == 1) {
        patch.sides.emplace(edge, count);
        patch.chains.push_back({{edge.first, edge.second}, 1});
      }
    }
  }

  /// Calls visit(mesh) for meshes with one edge cut or one point drawn, until it returns `false`.
  template <class Visit>
  void for_each_trial(const Patch& patch, const Visit& visit) const {
    std::set<Edge> edges;
    for (const Triangle& t : patch.mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        edges.insert(edge_of(t[k], t[(k + 1) % 3]));
      }
    }
    const auto goes_on = [&](std::optional<Tetrahedra> trial) {
      return !trial || visit(*std::move(trial));
    };
    for (const Edge& edge : edges) {
      if (!patch.sides.contains(edge) &&
          !(goes_on(cut(patch.mesh, edge)) && goes_on(drawn(patch.mesh, edge.first, edge.second)) &&
            goes_on(drawn(patch.mesh, edge.second, edge.first)))) {
        return;
      }
    }
  }

  [[nodiscard]] std::optional<Tetrahedra> cut(const Tetrahedra& mesh, const Edge& edge) const {
    const auto [a, b] = edge;
    const Vec3 middle = (mesh.points[a] + mesh.points[b]) / 2;
    const auto there =
        surface_.nearest(middle, mesh.regions.front(), (mesh.points[b] - mesh.points[a]).norm());
    if (!there) {
      return std::nullopt;
    }
    Tetrahedra result = mesh;
    const auto added = static_cast<std::uint32_t>(mesh.points.size());
    result.points.push_back(there->point);
    result.freedoms.push_back(Freedom::region);
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      if (const Triangle& t = mesh.triangles[f]; has(t, a) && has(t, b)) {
        Triangle other = t;
        std::ranges::replace(result.triangles[f], a, added);
        std::ranges::replace(other, b, added);
        result.triangles.push_back(other);
        result.regions.push_back(mesh.regions[f]);
      }
    }
    return result;
  }

  [[nodiscard]] std::optional<Tetrahedra> drawn(const Tetrahedra& mesh, std::uint32_t from,
                                                std::uint32_t to) const {
    Tetrahedra result = mesh;
    std::vector<std::uint8_t> is_gone(mesh.triangles.size(), 0);
    std::set<std::uint32_t> about, common;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      const Triangle& t = mesh.triangles[f];
      if (has(t, from)) {
        about.insert(t.begin(), t.end());
        is_gone[f] = has(t, to) ? 1 : 0;
        std::ranges::replace(result.triangles[f], from, to);
      }
    }
    for (const Triangle& t : mesh.triangles) {
      if (has(t, to)) {
        std::ranges::copy_if(t, std::inserter(common, common.end()), [&](std::uint32_t v) {
          return v != from && v != to && about.contains(v);
        });
      }
    }
    if (mesh.freedoms[from] != Freedom::region || common.size() != 2) {
      return std::nullopt;  // else edges or triangles would be there twice
    }
    take_away(result, is_gone);
    return result;
  }

  /// Whether what has become of a patch is a 2-manifold with what is around it, looks as the patch
  /// did, and is near the surface.
  [[nodiscard]] bool fits(const Tetrahedra& made, const Patch& patch) const {
    const std::set<std::uint32_t> faces(patch.faces.begin(), patch.faces.end());
    const auto is_outside = [&](std::span<const std::uint32_t> points) {
      return std::ranges::any_of(at_.at(patch.points[points.front()]), [&](std::uint32_t g) {
        return !faces.contains(g) && std::ranges::all_of(points, [&](std::uint32_t v) {
          return has(mesh_.triangles[g], patch.points[v]);
        });
      });
    };
    const auto stays = [&](std::uint32_t v) { return v < patch.kept; };
    std::map<Edge, int> sides;
    for (const Triangle& t : made.triangles) {
      if (std::ranges::all_of(t, stays) && is_outside(t)) {
        return false;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        ++sides[edge_of(t[k], t[(k + 1) % 3])];
      }
      const std::array<Vec3, 3> corners = {made.points[t[0]], made.points[t[1]], made.points[t[2]]};
      for (std::size_t k = 0; k < 3; ++k) {
        if ((corners[(k + 1) % 3] - corners[k]).norm() > limits_.longest_edge) {
          return false;
        }
      }
      if (!surface_.looks_near(corners, made.regions.front(), limits_.distance) ||
          !faces_outward(corners, patch)) {
        return false;
      }
    }
    return std::ranges::all_of(
               patch.sides, [&](const auto& item) { return sides[item.first] == item.second; }) &&
           std::ranges::all_of(sides, [&](const auto& item) {
             const auto& [edge, count] = item;
             const std::array<std::uint32_t, 2> ends = {edge.first, edge.second};
             return patch.sides.contains(edge) ||
                    (count == 2 && !(std::ranges::all_of(ends, stays) && is_outside(ends)));
           });
  }

  /// Whether a triangle is turned as that of the patch is whose middle is nearest to its own.
  [[nodiscard]] static bool faces_outward(const std::array<Vec3, 3>& corners, const Patch& patch) {
    const auto normal_of = [](const Vec3& a, const Vec3& b, const Vec3& c) {
      return Vec3((b - a).cross(c - a));
    };
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
    double least = std::numeric_limits<double>::infinity();
    Vec3 outward = Vec3::Zero();
    for (const auto& [a, b, c] : patch.mesh.triangles) {
      const Vec3 &p = patch.mesh.points[a], &q = patch.mesh.points[b], &r = patch.mesh.points[c];
      const Vec3 there = mesh::nearest_on_triangle(middle, p, q, r);
      if (const double far = (there - middle).squaredNorm(); far < least) {
        least = far;
        outward = normal_of(p, q, r);
      }
    }
    return normal_of(corners[0], corners[1], corners[2]).dot(outward) > 0;
  }

  void put(const Tetrahedra& made, const Patch& patch) {
    for (const std::uint32_t v : patch.points) {
      is_changed_[v] = 1;
    }
    for (const std::uint32_t g : patch.faces) {
      is_gone_[g] = 1;
    }
    std::vector<std::uint32_t> numbers(
        patch.points.begin(), patch.points.begin() + static_cast<std::ptrdiff_t>(patch.kept));
    for (std::size_t i = patch.kept; i < made.points.size(); ++i) {
      numbers.push_back(static_cast<std::uint32_t>(mesh_.points.size()));
      mesh_.points.push_back(made.points[i]);
      mesh_.freedoms.push_back(Freedom::region);
    }
    for (std::size_t f = 0; f < made.triangles.size(); ++f) {
      const auto& [a, b, c] = made.triangles[f];
      mesh_.triangles.push_back({numbers[a], numbers[b], numbers[c]});
      mesh_.regions.push_back(made.regions[f]);
    }
  }

  Tetrahedra& mesh_;
  const mesh::ReferenceSurface& surface_;
  const std::set<Edge>& curves_;
  double wanted_;
  const MoveLimits& limits_;
  Incidence<Triangle> at_;                // of what was there before the round
  std::vector<std::uint8_t> is_changed_;  // per point: of a patch that is not as it was
  std::vector<std::uint8_t> is_gone_;     // per triangle
};

}  // namespace

bool try_patches(Tetrahedra& mesh, const mesh::ReferenceSurface& surface,
                 std::span<const BorderChain> chains, double wanted, const MoveLimits& limits) {
  const std::set<Edge> curves = edges_of(chains);
  std::size_t left = kMostPatches + mesh.triangles.size() / kTrianglesPerPatch;
  bool has_changed = false;
  for (int round = 0; round < kRounds && Round(mesh, surface, curves, wanted, limits).run(left);
       ++round) {
    has_changed = true;
  }
  return has_changed;
}

}  // namespace dupin::meshing
