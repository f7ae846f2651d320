#include "healing/shell_enclosure.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "arrangement/arrange.h"
#include "checking/self_intersection.h"
#include "healing/shell_lobes.h"
#include "healing/sorted_copies.h"
#include "mesh/edge_table.h"
#include "mesh/exact_mesh.h"
#include "mesh/shell_nesting.h"
#include "support/disjoint_sets.h"

namespace dupin::healing {
namespace {

using ShellPair = std::pair<std::uint32_t, std::uint32_t>;  // outer, inner

/// The number of the copies that each face is one of, doubled, and one more if it runs the other
/// way round.
std::vector<std::uint32_t> numbers_of_copies(std::span<const Triangle> triangles) {
  std::vector<std::uint32_t> numbers(triangles.size());
  const std::vector<Copy> sorted = sorted_copies(triangles);
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    number += i > 0 && sorted[i].corners != sorted[i - 1].corners ? 2 : 0;
    numbers[sorted[i].face] = number + (sorted[i].is_odd ? 1 : 0);
  }
  return numbers;
}

class EnclosureFinder {
 public:
  EnclosureFinder(const PolygonSoup& soup, const mesh::Shells& shells, std::span<const int> signs)
      : soup_(soup),
        shells_(shells),
        signs_(signs),
        mesh_(soup.points, soup.triangles),
        edges_(soup.triangles, soup.points.size()),
        nest_(mesh_, shells) {}

  std::vector<std::vector<std::uint32_t>> find() {
    std::vector<std::vector<std::uint32_t>> around(shells_.count);
    if (shells_.count < 2) {
      return around;
    }
    copies_ = numbers_of_copies(soup_.triangles);
    group_copies();
    find_candidates();
    if (candidates_.empty()) {
      return around;
    }
    find_edges();
    find_crossing();
    for (const ShellPair& pair : candidates_) {
      if (encloses(pair)) {
        for (const std::uint32_t inner : same_as_[pair.second]) {
          around[inner].insert(around[inner].end(), same_as_[pair.first].begin(),
                               same_as_[pair.first].end());
        }
      }
    }
    for (auto& outer : around) {
      std::ranges::sort(outer);
    }
    return one_way(around);
  }

 private:
  // Without those of one place, however their faces divide it.
  static std::vector<std::vector<std::uint32_t>> one_way(
      const std::vector<std::vector<std::uint32_t>>& around) {
    std::vector<std::vector<std::uint32_t>> kept(around.size());
    for (std::uint32_t shell = 0; shell < around.size(); ++shell) {
      std::ranges::copy_if(
          around[shell], std::back_inserter(kept[shell]),
          [&](std::uint32_t outer) { return !std::ranges::binary_search(around[outer], shell); });
    }
    return kept;
  }

  // Of shells of the same faces that turn the same way, or all the other way, one stands for all.
  void group_copies() {
    same_as_.resize(shells_.count);
    std::map<std::vector<std::uint32_t>, std::uint32_t> first;
    for (std::uint32_t shell = 0; shell < shells_.count; ++shell) {
      std::vector<std::uint32_t> turned = turned_faces_of(shell);
      faces_.push_back(turned);
      for (std::uint32_t& face : faces_.back()) {
        face /= 2;
      }
      same_as_[first.try_emplace(std::move(turned), shell).first->second].push_back(shell);
    }
  }

  // By copies_, ascending, the first one even.
  [[nodiscard]] std::vector<std::uint32_t> turned_faces_of(std::uint32_t shell) const {
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t face : shells_.faces_of(shell)) {
      numbers.push_back(copies_[face]);
    }
    const std::uint32_t turn = numbers.empty() ? 0 : std::ranges::min(numbers) % 2;
    for (std::uint32_t& number : numbers) {
      number ^= turn;
    }
    std::ranges::sort(numbers);
    return numbers;
  }

  // By boxes, ascending.
  void find_candidates() {
    for (std::uint32_t inner = 0; inner < shells_.count; ++inner) {
      if (same_as_[inner].empty() || signs_[inner] == 0) {
        continue;
      }
      nest_.visit_boxes_around(inner, 0, [&](std::size_t outer) {
        if (!same_as_[outer].empty() && signs_[outer] != 0) {
          candidates_.emplace_back(static_cast<std::uint32_t>(outer), inner);
        }
      });
    }
    std::ranges::sort(candidates_);
  }

  [[nodiscard]] bool is_candidate(std::uint32_t a, std::uint32_t b) const {
    return std::ranges::binary_search(candidates_, ShellPair(a, b)) ||
           std::ranges::binary_search(candidates_, ShellPair(b, a));
  }

  void find_edges() {
    edge_of_.resize(3 * soup_.triangles.size());
    for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
      for (const std::uint32_t h : edges_[edge].half_edges) {
        edge_of_[h] = edge;
      }
    }
  }

  // Those that meet otherwise than in corners, edges and faces.
  void find_crossing() {
    std::vector<std::uint8_t> is_candidate_shell(shells_.count, 0), is_inner(shells_.count, 0);
    for (const auto& [outer, inner] : candidates_) {
      is_candidate_shell[outer] = is_candidate_shell[inner] = is_inner[inner] = 1;
    }
    std::vector<std::uint32_t> faces;
    std::vector<Triangle> triangles;
    std::vector<std::uint8_t> is_active;
    for (std::uint32_t face = 0; face < soup_.triangles.size(); ++face) {
      if (is_candidate_shell[shells_.of_face[face]]) {
        faces.push_back(face);
        triangles.push_back(soup_.triangles[face]);
        is_active.push_back(is_inner[shells_.of_face[face]]);
      }
    }
    const auto is_wanted = [&](std::uint32_t i, std::uint32_t k) {
      const std::uint32_t a = faces[i], b = faces[k];
      return copies_[a] / 2 != copies_[b] / 2 &&
             is_candidate(shells_.of_face[a], shells_.of_face[b]);
    };
    const auto found = checking::find_self_intersections(
        soup_.points, triangles, {.active = is_active, .contacts = false, .examined = is_wanted});
    for (const checking::FacePair& pair : found.pairs) {
      crossing_.push_back(
          std::minmax(shells_.of_face[faces[pair.first]], shells_.of_face[faces[pair.second]]));
    }
    std::ranges::sort(crossing_);
    crossing_.erase(std::unique(crossing_.begin(), crossing_.end()), crossing_.end());
  }

  bool encloses(const ShellPair& pair) {
    const auto [outer, inner] = pair;
    if (faces_[outer] == faces_[inner]) {
      return false;
    }
    if (std::ranges::binary_search(crossing_, ShellPair(std::minmax(outer, inner)))) {
      return is_nothing_left(region(inner), region(outer));
    }
    const std::vector<std::uint32_t> apart = faces_apart(inner, outer);
    return !apart.empty() && std::ranges::all_of(apart, [&](std::uint32_t face) {
      return nest_.encloses(outer, mesh::point_within(mesh_, face));
    });
  }

  // Of each part of the inner shell between edges of the outer one, where they may cross: the face
  // that rays cost least. None for what is the outer shell's, too.
  [[nodiscard]] std::vector<std::uint32_t> faces_apart(std::uint32_t inner,
                                                       std::uint32_t outer) const {
    const auto of_inner = shells_.faces_of(inner);
    const std::vector<std::uint32_t> parts = parts_between_edges_of(outer, of_inner);
    std::map<std::uint32_t, std::pair<double, std::uint32_t>> cheapest;
    for (std::size_t i = 0; i < of_inner.size(); ++i) {
      const std::uint32_t face = of_inner[i];
      if (!std::ranges::binary_search(faces_[outer], copies_[face] / 2)) {
        const std::pair candidate(mesh::ray_cost(mesh_, face), face);
        const auto [at, is_new] = cheapest.try_emplace(parts[i], candidate);
        at->second = std::min(at->second, candidate);
      }
    }
    std::vector<std::uint32_t> faces;
    for (const auto& [part, candidate] : cheapest) {
      faces.push_back(candidate.second);
    }
    return faces;
  }

  // Per face of a shell the first one of its part.
  [[nodiscard]] std::vector<std::uint32_t> parts_between_edges_of(
      std::uint32_t outer, std::span<const std::uint32_t> of_inner) const {
    constexpr std::size_t kMany = 64;  // more parts than there are do no harm
    const auto place = [&](std::uint32_t face) {
      return static_cast<std::uint32_t>(std::ranges::lower_bound(of_inner, face) -
                                        of_inner.begin());
    };
    const auto shell_at = [this](std::uint32_t h) { return shells_.of_face[h / 3]; };
    support::DisjointSets parts(of_inner.size());
    for (std::uint32_t i = 0; i < of_inner.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const auto along = edges_[edge_of_[3 * of_inner[i] + k]].half_edges;
        if (along.size() > kMany || std::ranges::find(along, outer, shell_at) != along.end()) {
          continue;
        }
        for (const std::uint32_t h : along) {
          if (shell_at(h) == shells_.of_face[of_inner[i]]) {
            parts.unite(i, place(h / 3));
          }
        }
      }
    }
    return parts.representatives();
  }

  static bool is_nothing_left(const mesh::ExactMesh& of, const mesh::ExactMesh& without) {
    const std::array<const mesh::ExactMesh*, 2> operands{&of, &without};
    return arrangement::arrange(operands, arrangement::difference_rule(2)).triangles.empty();
  }

  // What the shell winds around, its volume being positive.
  const mesh::ExactMesh& region(std::uint32_t shell) {
    const auto [at, is_new] = regions_.try_emplace(shell);
    if (is_new) {
      at->second = arrangement::positive_winding_boundary(
          surface_of(soup_, shells_.faces_of(shell), signs_[shell] < 0));
    }
    return at->second;
  }

  const PolygonSoup& soup_;
  const mesh::Shells& shells_;
  std::span<const int> signs_;
  mesh::MeshView mesh_;
  mesh::EdgeTable edges_;
  std::vector<std::uint32_t> edge_of_;  // per half-edge
  mesh::ShellNest nest_;
  std::vector<ShellPair> candidates_;
  std::vector<std::uint32_t> copies_;                // per face
  std::vector<std::vector<std::uint32_t>> faces_;    // of each shell, by copies_ / 2; ascending
  std::vector<std::vector<std::uint32_t>> same_as_;  // of the first of some; ascending
  std::vector<ShellPair> crossing_;                  // the lower one first
  std::map<std::uint32_t, mesh::ExactMesh> regions_;
};

}  // namespace

ShellEnclosure::ShellEnclosure(const PolygonSoup& soup, const mesh::Shells& shells,
                               std::span<const int> signs)
    : around_(EnclosureFinder(soup, shells, signs).find()) {}

}  // namespace dupin::healing
