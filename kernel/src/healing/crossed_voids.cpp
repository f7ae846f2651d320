#include "healing/crossed_voids.h"

#include <algorithm>

#include "healing/closed_shells.h"
#include "mesh/edge_table.h"
#include "mesh/measure.h"
#include "mesh/self_contact.h"
#include "support/sequences.h"

namespace dupin::healing {
namespace {

class CrossedVoidFinder {
 public:
  CrossedVoidFinder(std::span<const Vec3> points, std::span<const Triangle> triangles,
                    std::span<const std::uint8_t> was_turned,
                    std::span<const std::uint8_t> is_of_cavity)
      : was_turned_(was_turned),
        is_of_cavity_(is_of_cavity),
        mesh_(points, triangles),
        edges_(triangles, points.size()),
        voids_(closed_shells(points, triangles, Wedges::voids).shells) {}

  std::vector<std::uint32_t> find() {
    find_seams();
    std::vector<std::uint32_t> found;
    for (std::size_t shell = 0; shell < voids_.count; ++shell) {
      const auto faces = voids_.faces_of(shell);
      if (seams_[shell] == Seam::crossing && is_void(faces)) {
        found.insert(found.end(), faces.begin(), faces.end());
      }
    }
    return found;
  }

 private:
  /// Where what was turned meets what was not.
  enum class Seam : std::uint8_t { none, crossing, touching };

  // One where bodies lie on each other tells that they do not cross.
  void find_seams() {
    seams_.resize(voids_.count, Seam::none);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const mesh::Edge edge = edges_[i];
      if (edge.half_edges.size() == 2) {
        continue;
      }
      for (const std::uint32_t shell : mixed_at(edge)) {
        if (seams_[shell] != Seam::touching) {
          seams_[shell] = count_half_planes(edge) < 4 ? Seam::touching : Seam::crossing;
        }
      }
    }
  }

  // The shells that have faces there that were turned, and others that were not.
  [[nodiscard]] std::vector<std::uint32_t> mixed_at(const mesh::Edge& edge) const {
    std::vector<std::pair<std::uint32_t, std::uint8_t>> at_edge;
    for (const std::uint32_t h : edge.half_edges) {
      at_edge.emplace_back(voids_.of_face[h / 3], was_turned_[h / 3]);
    }
    support::sort_unique(at_edge);
    std::vector<std::uint32_t> mixed;
    for (std::size_t i = 1; i < at_edge.size(); ++i) {
      if (at_edge[i - 1].first == at_edge[i].first) {
        mixed.push_back(at_edge[i].first);
      }
    }
    return mixed;
  }

  [[nodiscard]] std::size_t count_half_planes(const mesh::Edge& edge) const {
    const auto around = mesh::sorted_around(mesh_, edges_, edge);
    std::size_t count = 0;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const std::uint32_t next = around[(i + 1) % around.size()];
      count += mesh::in_one_half_plane(mesh_, edges_, edge, around[i], next) ? 0 : 1;
    }
    return count;
  }

  [[nodiscard]] bool is_void(std::span<const std::uint32_t> faces) const {
    return std::ranges::none_of(faces, [&](std::uint32_t f) { return is_of_cavity_[f] != 0; }) &&
           mesh::volume_sign({mesh_.points, support::selected(mesh_.triangles, faces)}) < 0;
  }

  std::span<const std::uint8_t> was_turned_, is_of_cavity_;
  mesh::MeshView mesh_;
  mesh::EdgeTable edges_;
  mesh::Shells voids_;
  std::vector<Seam> seams_;  // per shell
};

}  // namespace

std::vector<std::uint32_t> faces_of_crossed_voids(std::span<const Vec3> points,
                                                  std::span<const Triangle> triangles,
                                                  std::span<const std::uint8_t> was_turned,
                                                  std::span<const std::uint8_t> is_of_cavity) {
  return CrossedVoidFinder(points, triangles, was_turned, is_of_cavity).find();
}

}  // namespace dupin::healing
