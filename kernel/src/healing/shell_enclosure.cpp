#include "healing/shell_enclosure.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "arrangement/arrange.h"
#include "checking/self_intersection.h"
#include "healing/sorted_copies.h"
#include "mesh/exact_mesh.h"
#include "mesh/shell_nesting.h"
#include "support/none.h"

namespace dupin::healing {
namespace {

using ShellPair = std::pair<std::uint32_t, std::uint32_t>;  // outer, inner

/// The number of the copies that a face is one of.
std::vector<std::uint32_t> numbers_of_copies(std::span<const Triangle> triangles) {
  std::vector<std::uint32_t> numbers(triangles.size());
  const std::vector<Copy> sorted = sorted_copies(triangles);
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const bool is_copy = sorted[i].corners == sorted[i - 1].corners;
    numbers[sorted[i].face] = numbers[sorted[i - 1].face] + (is_copy ? 0 : 1);
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
        nest_(mesh_, shells) {}

  std::vector<std::vector<std::uint32_t>> find() {
    find_candidates();
    std::vector<std::vector<std::uint32_t>> around(shells_.count);
    if (candidates_.empty()) {
      return around;
    }
    copies_ = numbers_of_copies(soup_.triangles);
    for (std::uint32_t shell = 0; shell < shells_.count; ++shell) {
      faces_.push_back(faces_of(shell));
    }
    find_crossing();
    for (const ShellPair& pair : candidates_) {
      if (encloses(pair)) {
        around[pair.second].push_back(pair.first);
      }
    }
    return around;
  }

 private:
  // By boxes, ascending.
  void find_candidates() {
    for (std::uint32_t inner = 0; inner < shells_.count; ++inner) {
      nest_.visit_boxes_around(inner, 0, [&](std::size_t outer) {
        if (signs_[inner] != 0 && signs_[outer] != 0) {
          candidates_.emplace_back(static_cast<std::uint32_t>(outer), inner);
        }
      });
    }
    std::ranges::sort(candidates_);
  }

  [[nodiscard]] std::vector<std::uint32_t> faces_of(std::uint32_t shell) const {
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t face : shells_.faces_of(shell)) {
      numbers.push_back(copies_[face]);
    }
    std::ranges::sort(numbers);
    return numbers;
  }

  [[nodiscard]] bool is_candidate(std::uint32_t a, std::uint32_t b) const {
    return std::ranges::binary_search(candidates_, ShellPair(a, b)) ||
           std::ranges::binary_search(candidates_, ShellPair(b, a));
  }

  // Those that meet otherwise than in corners, edges and faces.
  void find_crossing() {
    std::vector<std::uint8_t> is_active(soup_.triangles.size(), 0);
    for (const auto& [outer, inner] : candidates_) {
      for (const std::uint32_t face : shells_.faces_of(inner)) {
        is_active[face] = 1;
      }
    }
    const auto is_wanted = [this](std::uint32_t a, std::uint32_t b) {
      return copies_[a] != copies_[b] && is_candidate(shells_.of_face[a], shells_.of_face[b]);
    };
    const auto found = checking::find_self_intersections(
        soup_.points, soup_.triangles,
        {.active = is_active, .contacts = false, .examined = is_wanted});
    for (const checking::FacePair& pair : found.pairs) {
      const std::uint32_t a = shells_.of_face[pair.first], b = shells_.of_face[pair.second];
      crossing_.emplace_back(std::min(a, b), std::max(a, b));
    }
    std::ranges::sort(crossing_);
    crossing_.erase(std::ranges::unique(crossing_).begin(), crossing_.end());
  }

  bool encloses(const ShellPair& pair) {
    const auto [outer, inner] = pair;
    if (faces_[outer] == faces_[inner]) {
      return false;
    }
    if (std::ranges::binary_search(crossing_, ShellPair(std::minmax(outer, inner)))) {
      return is_nothing_left(region(inner), region(outer));
    }
    const std::uint32_t face = face_apart(inner, outer);
    return face != support::kNone && nest_.encloses(outer, mesh::point_within(mesh_, face));
  }

  // That rays cost least, and is none of the outer shell's.
  [[nodiscard]] std::uint32_t face_apart(std::uint32_t inner, std::uint32_t outer) const {
    std::uint32_t best = support::kNone;
    double least = 0;
    for (const std::uint32_t face : shells_.faces_of(inner)) {
      const double cost = mesh::ray_cost(mesh_, face);
      if ((best == support::kNone || cost < least) &&
          !std::ranges::binary_search(faces_[outer], copies_[face])) {
        best = face;
        least = cost;
      }
    }
    return best;
  }

  static bool is_nothing_left(const mesh::ExactMesh& of, const mesh::ExactMesh& without) {
    const std::array<const mesh::ExactMesh*, 2> operands{&of, &without};
    return arrangement::arrange(operands, arrangement::difference_rule(2)).triangles.empty();
  }

  // What the shell winds around, its volume being positive.
  const mesh::ExactMesh& region(std::uint32_t shell) {
    const auto [at, is_new] = regions_.try_emplace(shell);
    if (is_new) {
      mesh::ExactMesh surface;
      std::unordered_map<std::uint32_t, std::uint32_t> number;
      for (const std::uint32_t face : shells_.faces_of(shell)) {
        Triangle t = soup_.triangles[face];
        for (std::uint32_t& corner : t) {
          const auto place = number.emplace(corner, static_cast<std::uint32_t>(number.size()));
          if (place.second) {
            surface.points.push_back(soup_.points[corner]);
          }
          corner = place.first->second;
        }
        if (signs_[shell] < 0) {
          std::swap(t[1], t[2]);
        }
        surface.triangles.push_back(t);
        surface.sources.push_back({0, face});
      }
      at->second = arrangement::positive_winding_boundary(surface);
    }
    return at->second;
  }

  const PolygonSoup& soup_;
  const mesh::Shells& shells_;
  std::span<const int> signs_;
  mesh::MeshView mesh_;
  mesh::ShellNest nest_;
  std::vector<ShellPair> candidates_;
  std::vector<std::uint32_t> copies_;              // per face
  std::vector<std::vector<std::uint32_t>> faces_;  // of each shell, by copies_; ascending
  std::vector<ShellPair> crossing_;                // the lower one first
  std::map<std::uint32_t, mesh::ExactMesh> regions_;
};

}  // namespace

ShellEnclosure::ShellEnclosure(const PolygonSoup& soup, const mesh::Shells& shells,
                               std::span<const int> signs)
    : around_(EnclosureFinder(soup, shells, signs).find()) {}

std::vector<int> ShellEnclosure::depths() const {
  std::vector<int> depths;
  depths.reserve(around_.size());
  for (const auto& outer : around_) {
    depths.push_back(static_cast<int>(outer.size()));
  }
  return depths;
}

}  // namespace dupin::healing
