#include "meshing/edge_cuts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "meshing/edge_edits.h"

namespace dupin::meshing {
namespace {

constexpr int kRounds = 8;

/// Cuts of one round, no two of which are of the same triangle.
class Round {
 public:
  Round(Tetrahedra& mesh, const mesh::ReferenceSurface& surface, const std::set<Edge>& kept,
        double distance)
      : mesh_(mesh), surface_(surface), kept_(kept), distance_(distance) {}

  bool run() {
    find_sides();
    std::map<Edge, double> far;
    for (const auto& [edge, faces] : sides_) {
      if (is_far((mesh_.points[edge.first] + mesh_.points[edge.second]) / 2)) {
        far.emplace(edge, length(edge));
      }
    }
    for (const Triangle& t : mesh_.triangles) {
      if (is_far((mesh_.points[t[0]] + mesh_.points[t[1]] + mesh_.points[t[2]]) / 3) &&
          !has_far_edge_of_chain(t)) {
        if (const std::optional<Edge> edge = longest(t)) {
          far.emplace(*edge, length(*edge));
        }
      }
    }
    std::vector<std::pair<double, Edge>> order;
    order.reserve(far.size());
    for (const auto& [edge, length] : far) {
      order.emplace_back(-length, edge);
    }
    std::ranges::sort(order);
    std::vector<std::uint8_t> is_cut(mesh_.triangles.size(), 0);
    bool has_cut = false;
    for (const auto& [length, edge] : order) {
      const std::vector<std::uint32_t>& faces = sides_.at(edge);
      if (faces.size() == 2 && is_cut[faces[0]] == 0 && is_cut[faces[1]] == 0 && cut(edge, faces)) {
        is_cut[faces[0]] = is_cut[faces[1]] = 1;
        has_cut = true;
      }
    }
    return has_cut;
  }

 private:
  [[nodiscard]] double length(const Edge& edge) const {
    return (mesh_.points[edge.first] - mesh_.points[edge.second]).norm();
  }
  [[nodiscard]] bool is_far(const Vec3& place) const {
    return !surface_.nearest(place, mesh_.regions.front(), distance_);
  }

  /// Of the edges that may be cut, with the triangles at each.
  void find_sides() {
    for (std::uint32_t f = 0; f < mesh_.triangles.size(); ++f) {
      const Triangle& t = mesh_.triangles[f];
      for (std::size_t k = 0; k < 3; ++k) {
        const Edge edge = edge_of(t[k], t[(k + 1) % 3]);
        if (!kept_.contains(edge)) {
          sides_[edge].push_back(f);
        }
      }
    }
  }
  [[nodiscard]] std::optional<Edge> longest(const Triangle& t) const {
    std::optional<Edge> longest;
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge = edge_of(t[k], t[(k + 1) % 3]);
      if (!kept_.contains(edge) && (!longest || length(edge) > length(*longest))) {
        longest = edge;
      }
    }
    return longest;
  }

  /// Beside it triangles stay far, however short they get.
  [[nodiscard]] bool has_far_edge_of_chain(const Triangle& t) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (kept_.contains(edge_of(t[k], t[(k + 1) % 3])) &&
          is_far((mesh_.points[t[k]] + mesh_.points[t[(k + 1) % 3]]) / 2)) {
        return true;
      }
    }
    return false;
  }

  bool cut(const Edge& edge, const std::vector<std::uint32_t>& faces) {
    const auto [a, b] = edge;
    const auto there = surface_.nearest((mesh_.points[a] + mesh_.points[b]) / 2,
                                        mesh_.regions.front(), length(edge));
    if (!there) {
      return false;
    }
    const auto added = static_cast<std::uint32_t>(mesh_.points.size());
    mesh_.points.push_back(there->point);
    std::array<Triangle, 2> at_a{}, at_b{};
    bool is_turned = false;
    for (std::size_t i = 0; i < 2; ++i) {
      const Triangle& t = mesh_.triangles[faces[i]];
      at_a[i] = at_b[i] = t;
      std::ranges::replace(at_a[i], b, added);
      std::ranges::replace(at_b[i], a, added);
      is_turned = is_turned || !(normal(t).dot(normal(at_a[i])) > 0) ||
                  !(normal(t).dot(normal(at_b[i])) > 0);
    }
    if (is_turned) {
      mesh_.points.pop_back();
      return false;
    }
    mesh_.freedoms.push_back(Freedom::region);
    for (std::size_t i = 0; i < 2; ++i) {
      mesh_.triangles[faces[i]] = at_a[i];
      mesh_.triangles.push_back(at_b[i]);
      mesh_.regions.push_back(mesh_.regions.front());
    }
    return true;
  }
  [[nodiscard]] Vec3 normal(const Triangle& t) const {
    const Vec3& a = mesh_.points[t[0]];
    return (mesh_.points[t[1]] - a).cross(mesh_.points[t[2]] - a);
  }

  Tetrahedra& mesh_;
  const mesh::ReferenceSurface& surface_;
  const std::set<Edge>& kept_;
  double distance_;
  std::map<Edge, std::vector<std::uint32_t>> sides_;
};

}  // namespace

bool cut_far_edges(Tetrahedra& mesh, const mesh::ReferenceSurface& surface,
                   std::span<const BorderChain> chains, double distance) {
  const std::set<Edge> kept = edges_of(chains);
  bool has_cut = false;
  for (int round = 0; round < kRounds && Round(mesh, surface, kept, distance).run(); ++round) {
    has_cut = true;
  }
  return has_cut;
}

}  // namespace dupin::meshing
