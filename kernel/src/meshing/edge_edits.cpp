#include "meshing/edge_edits.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "meshing/incidence.h"
#include "support/none.h"

namespace dupin::meshing {
namespace {

constexpr int kRounds = 8;
/// An edit has to gain so much, in radians.
constexpr double kGain = 1e-6;

/// Edits of one round, none of which has a point in common with what another one has changed.
class Round {
 public:
  Round(Tetrahedra& mesh, const mesh::ReferenceSurface& surface, const std::set<Edge>& kept,
        double wanted, const MoveLimits& limits)
      : mesh_(mesh),
        surface_(surface),
        kept_(kept),
        wanted_(wanted),
        limits_(limits),
        at_(mesh.triangles, mesh.points.size()),
        is_changed_(mesh.points.size(), 0),
        is_gone_(mesh.triangles.size(), 0) {}

  bool run() {
    bool has_edited = false;
    const auto count = static_cast<std::uint32_t>(mesh_.triangles.size());
    for (std::uint32_t f = 0; f < count; ++f) {
      if (angle_of(mesh_.triangles[f]) < wanted_) {
        has_edited = edit(f) || has_edited;
      }
    }
    if (has_edited) {
      take_away(mesh_, is_gone_);
    }
    return has_edited;
  }

 private:
  [[nodiscard]] std::array<Vec3, 3> corners_of(const Triangle& t) const {
    return {mesh_.points[t[0]], mesh_.points[t[1]], mesh_.points[t[2]]};
  }
  [[nodiscard]] double angle_of(const Triangle& t) const {
    const auto& [a, b, c] = corners_of(t);
    return smallest_angle(a, b, c);
  }
  [[nodiscard]] Vec3 normal_of(const Triangle& t) const {
    const auto& [a, b, c] = corners_of(t);
    return (b - a).cross(c - a);
  }

  /// What some triangles become.
  struct Edit {
    std::vector<std::uint32_t> faces;  ///< that are there now
    std::vector<Triangle> triangles;   ///< in place of the first of them; the others vanish
  };

  bool edit(std::uint32_t f) {
    const Triangle t = mesh_.triangles[f];
    if (std::ranges::any_of(t, [&](std::uint32_t v) { return is_changed_[v] != 0; })) {
      return false;
    }
    Edit best;
    double most = 0;
    const auto consider = [&](Edit edit) {
      if (const double gain = gain_of(edit); gain > std::max(most, kGain)) {
        most = gain;
        best = std::move(edit);
      }
    };
    for (std::size_t k = 0; k < 3; ++k) {
      consider(turned(t[k], t[(k + 1) % 3], t[(k + 2) % 3], f));
      for (const std::uint32_t face : at_.at(t[k])) {
        for (const std::uint32_t to : mesh_.triangles[face]) {
          if (to != t[k]) {
            consider(drawn(t[k], to));
          }
        }
      }
    }
    if (most == 0) {
      return false;
    }
    apply(best);
    return true;
  }

  /// Of the smallest angle; 0 if the edit is none, or is not allowed.
  [[nodiscard]] double gain_of(const Edit& edit) const {
    double before = std::numbers::pi, after = before;
    for (const std::uint32_t f : edit.faces) {
      before = std::min(before, angle_of(mesh_.triangles[f]));
    }
    for (const Triangle& t : edit.triangles) {
      after = std::min(after, angle_of(t));
    }
    const auto is_allowed = [&](const Triangle& t) {
      const auto& [a, b, c] = corners_of(t);
      const Vec3 normal = normal_of(t);
      return std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()}) <= limits_.longest_edge &&
             std::ranges::all_of(
                 edit.faces,
                 [&](std::uint32_t f) { return normal.dot(normal_of(mesh_.triangles[f])) > 0; }) &&
             surface_.looks_near({a, b, c}, mesh_.regions[edit.faces.front()], limits_.distance);
    };
    return !edit.triangles.empty() && after > before &&
                   std::ranges::none_of(edit.triangles,
                                        [&](const Triangle& t) {
                                          return std::ranges::any_of(t, [&](std::uint32_t v) {
                                            return is_changed_[v] != 0;
                                          });
                                        }) &&
                   std::ranges::all_of(edit.triangles, is_allowed)
               ? after - before
               : 0;
  }

  /// The edge from a to b of a triangle with c, turned.
  [[nodiscard]] Edit turned(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                            std::uint32_t f) const {
    if (kept_.contains(edge_of(a, b))) {
      return {};
    }
    Edit edit;
    for (const std::uint32_t g : at_.at(a)) {
      if (g != f && has(mesh_.triangles[g], b)) {
        const Triangle& t = mesh_.triangles[g];
        const std::uint32_t d =
            *std::ranges::find_if(t, [&](std::uint32_t v) { return v != a && v != b; });
        const bool has_edge = std::ranges::any_of(
            at_.at(c), [&](std::uint32_t h) { return has(mesh_.triangles[h], d); });
        if (!has_edge) {
          edit = {{f, g}, {{a, d, c}, {d, b, c}}};
        }
      }
    }
    return edit;
  }

  /// A point drawn into another one.
  [[nodiscard]] Edit drawn(std::uint32_t from, std::uint32_t to) const {
    if (mesh_.freedoms[from] != Freedom::region) {
      return {};
    }
    Edit edit;
    std::set<std::uint32_t> about, common;
    for (const std::uint32_t f : at_.at(from)) {
      Triangle t = mesh_.triangles[f];
      edit.faces.push_back(f);
      about.insert(t.begin(), t.end());
      if (!has(t, to)) {
        std::ranges::replace(t, from, to);
        edit.triangles.push_back(t);
      }
    }
    for (const std::uint32_t f : at_.at(to)) {
      for (const std::uint32_t v : mesh_.triangles[f]) {
        if (v != from && v != to && about.contains(v)) {
          common.insert(v);
        }
      }
    }
    // Else edges or triangles would be there twice.
    return edit.triangles.size() + 2 == edit.faces.size() && common.size() == 2 ? edit : Edit();
  }

  void apply(const Edit& edit) {
    for (std::size_t i = 0; i < edit.faces.size(); ++i) {
      for (const std::uint32_t v : mesh_.triangles[edit.faces[i]]) {
        is_changed_[v] = 1;
      }
      if (i < edit.triangles.size()) {
        mesh_.triangles[edit.faces[i]] = edit.triangles[i];
      } else {
        is_gone_[edit.faces[i]] = 1;
      }
    }
  }

  Tetrahedra& mesh_;
  const mesh::ReferenceSurface& surface_;
  const std::set<Edge>& kept_;
  double wanted_;
  const MoveLimits& limits_;
  Incidence<Triangle> at_;
  std::vector<std::uint8_t> is_changed_;  // per point: of a triangle that is not as it was
  std::vector<std::uint8_t> is_gone_;     // per triangle
};

}  // namespace

Edge edge_of(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

bool has(const Triangle& triangle, std::uint32_t point) {
  return std::ranges::find(triangle, point) != triangle.end();
}

std::set<Edge> edges_of(std::span<const BorderChain> chains) {
  std::set<Edge> edges;
  for (const BorderChain& chain : chains) {
    for (std::size_t i = 1; i < chain.points.size(); ++i) {
      edges.insert(edge_of(chain.points[i - 1], chain.points[i]));
    }
  }
  return edges;
}

void take_away(Tetrahedra& mesh, const std::vector<std::uint8_t>& is_gone) {
  std::size_t next = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (is_gone[f] == 0) {
      mesh.triangles[next] = mesh.triangles[f];
      mesh.regions[next++] = mesh.regions[f];
    }
  }
  mesh.triangles.resize(next);
  mesh.regions.resize(next);
  std::vector<std::uint32_t> numbers(mesh.points.size(), support::kNone);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      numbers[v] = 0;
    }
  }
  next = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (numbers[v] == 0 || mesh.freedoms[v] != Freedom::region) {
      numbers[v] = static_cast<std::uint32_t>(next);
      mesh.points[next] = mesh.points[v];
      mesh.freedoms[next++] = mesh.freedoms[v];
    }
  }
  mesh.points.resize(next);
  mesh.freedoms.resize(next);
  for (Triangle& t : mesh.triangles) {
    std::ranges::transform(t, t.begin(), [&](std::uint32_t v) { return numbers[v]; });
  }
}

bool edit_edges(Tetrahedra& mesh, const mesh::ReferenceSurface& surface,
                std::span<const BorderChain> chains, double wanted, const MoveLimits& limits) {
  const std::set<Edge> kept = edges_of(chains);
  bool has_edited = false;
  for (int round = 0; round < kRounds && Round(mesh, surface, kept, wanted, limits).run();
       ++round) {
    has_edited = true;
  }
  return has_edited;
}

}  // namespace dupin::meshing
