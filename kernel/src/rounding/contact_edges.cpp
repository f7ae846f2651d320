#include "rounding/contact_edges.h"

#include <algorithm>
#include <utility>

#include "mesh/coincident_points.h"
#include "mesh/edge_table.h"
#include "mesh/self_contact.h"
#include "support/sequences.h"

namespace dupin::rounding {
namespace {

struct Touching {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  // by representatives, ascending
  bool is_alternating = true;
};

}  // namespace

/// All faces at those points of the star of a point that have others in their place, and the star,
/// whose faces may come to such a point; none where there are no such points.
class ContactEdges::Surroundings {
 public:
  Surroundings(const ContactEdges& all, const EditedMesh& mesh, std::uint32_t centre)
      : all_(all), mesh_(mesh) {
    for (const std::uint32_t face : mesh.faces(centre)) {
      for (const std::uint32_t corner : mesh.triangle(face)) {
        star_.push_back(all.representatives_[corner]);
      }
    }
    support::sort_unique(star_);
    for (const std::uint32_t place : star_) {
      if (all.is_shared_[place] != 0) {
        for (const std::uint32_t point : all.at_place_.at(place)) {
          faces_.insert(faces_.end(), mesh.faces(point).begin(), mesh.faces(point).end());
        }
      }
    }
    if (!faces_.empty()) {
      faces_.insert(faces_.end(), mesh.faces(centre).begin(), mesh.faces(centre).end());
    }
    support::sort_unique(faces_);
  }

  [[nodiscard]] bool are_plain() const { return faces_.empty(); }

  /// The edges within the star that have more than two faces, once `from` is where `to` is. One of
  /// their ends is a shared place (see mesh::find_contacts), so that all of their faces are known.
  [[nodiscard]] Touching touching(std::uint32_t from, std::uint32_t to) const {
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> used;
    for (const std::uint32_t face : faces_) {
      Triangle corners = mesh_.triangle(face);
      for (std::uint32_t& corner : corners) {
        corner = all_.representatives_[corner == from ? to : corner];
      }
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) {
        triangles.push_back(corners);
        used.insert(used.end(), corners.begin(), corners.end());
      }
    }
    support::sort_unique(used);
    for (Triangle& corners : triangles) {
      for (std::uint32_t& corner : corners) {
        corner = static_cast<std::uint32_t>(std::ranges::lower_bound(used, corner) - used.begin());
      }
    }
    const std::vector<Vec3> points = support::selected(mesh_.points(), used);
    return among(triangles, used, points);
  }

 private:
  [[nodiscard]] bool is_in_star(std::uint32_t place) const {
    return std::ranges::binary_search(star_, place);
  }

  [[nodiscard]] Touching among(std::span<const Triangle> triangles,
                               std::span<const std::uint32_t> used,
                               std::span<const Vec3> points) const {
    const mesh::EdgeTable edges(triangles, used.size());
    Touching result;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const mesh::Edge edge = edges[i];
      const std::uint32_t low = used[edge.low], high = used[edge.high];
      if (edge.half_edges.size() > 2 && is_in_star(low) && is_in_star(high)) {
        result.edges.emplace_back(low, high);
        result.is_alternating =
            result.is_alternating && mesh::alternates({points, triangles}, edges, edge);
      }
    }
    std::ranges::sort(result.edges);
    return result;
  }

  const ContactEdges& all_;
  const EditedMesh& mesh_;
  std::vector<std::uint32_t> star_, faces_;  // places; faces
};

ContactEdges::ContactEdges(std::span<const std::uint32_t> representatives)
    : representatives_(representatives.begin(), representatives.end()),
      is_shared_(mesh::shared_places(representatives)) {
  for (std::uint32_t point = 0; point < is_shared_.size(); ++point) {
    if (is_shared_[point] != 0) {
      at_place_[representatives_[point]].push_back(point);
    }
  }
}

bool ContactEdges::stay(const EditedMesh& mesh, std::uint32_t from, std::uint32_t to) const {
  if (at_place_.empty()) {
    return true;  // of most solids, whose stars need not be looked at
  }
  const Surroundings around(*this, mesh, from);
  if (around.are_plain()) {
    return true;
  }
  const Touching after = around.touching(from, to);
  return after.is_alternating && after.edges == around.touching(from, from).edges;
}

}  // namespace dupin::rounding
