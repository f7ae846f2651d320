#include "healing/degenerate_faces.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "dupin/kernel/error.h"
#include "mesh/edge_table.h"
#include "predicates/triangle_overlap.h"
#include "support/blocks.h"
#include "support/bulk_vector.h"
#include "support/disjoint_sets.h"
#include "support/sequences.h"

namespace dupin::healing {
namespace {

bool repeats_a_corner(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

std::size_t drop_faces_that_repeat_a_corner(PolygonSoup& soup) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    if (!repeats_a_corner(soup.triangles[i])) {
      soup.triangles[kept] = soup.triangles[i];
      soup.sources[kept++] = soup.sources[i];
    }
  }
  const std::size_t dropped = soup.triangles.size() - kept;
  soup.triangles.resize(kept);
  soup.sources.resize(kept);
  return dropped;
}

/// The corners of collinear triangles that hang together, in order along their line. On a line the
/// coordinates, compared one after the other, tell the order exactly.
class LinePoints {
 public:
  LinePoints(std::span<const Vec3> points, std::vector<std::uint32_t> ids)
      : points_(points), ids_(std::move(ids)) {
    std::sort(ids_.begin(), ids_.end(), [this](auto a, auto b) { return is_before(a, b); });
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
  }

  /// Strictly between two of them, from `from` to `to`.
  [[nodiscard]] std::vector<std::uint32_t> between(std::uint32_t from, std::uint32_t to) const {
    const bool is_forward = is_before(from, to);
    const auto before = [this](auto a, auto b) { return is_before(a, b); };
    const auto first = std::upper_bound(ids_.begin(), ids_.end(), is_forward ? from : to, before);
    const auto last = std::lower_bound(first, ids_.end(), is_forward ? to : from, before);
    std::vector<std::uint32_t> found(first, last);
    if (!is_forward) {
      std::reverse(found.begin(), found.end());
    }
    return found;
  }

 private:
  [[nodiscard]] bool is_before(std::uint32_t a, std::uint32_t b) const {
    const Vec3 &p = points_[a], &q = points_[b];
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  }

  std::span<const Vec3> points_;
  std::vector<std::uint32_t> ids_;
};

using Ids = std::vector<std::uint32_t>;

/// A proper triangle's edge from its corner `k` on.
struct DividedEdge {
  std::uint32_t face, k, line;
};

/// Per triangle 1 if its corners are collinear.
support::BulkVector<std::uint8_t> degenerate_faces(const PolygonSoup& soup) {
  support::BulkVector<std::uint8_t> degenerate(soup.triangles.size());
  support::for_each_block(degenerate.size(), [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const auto& [a, b, c] = soup.triangles[i];
      degenerate[i] = predicates::collinear(soup.points[a], soup.points[b], soup.points[c]) ? 1 : 0;
    }
  });
  return degenerate;
}

class DegenerateFaces {
 public:
  /// Of `is_degenerate`, some have a 1.
  DegenerateFaces(const PolygonSoup& soup, support::BulkVector<std::uint8_t> is_degenerate)
      : soup_(soup),
        is_degenerate_(std::move(is_degenerate)),
        near_(faces_near()),
        triangles_near_(support::selected(std::span<const Triangle>(soup.triangles), near_)),
        edges_(triangles_near_, soup.points.size()) {}

  /// The soup without them.
  [[nodiscard]] PolygonSoup replaced() const {
    const std::vector<std::uint32_t> number = number_lines();
    const std::vector<LinePoints> lines = find_lines(number);
    const std::vector<DividedEdge> divided = find_divided_edges(number);
    PolygonSoup result{soup_.points, {}, {}};
    auto edge = divided.begin();
    for (std::uint32_t face = 0; face < soup_.triangles.size(); ++face) {
      if (is_degenerate_[face]) {
        continue;
      }
      std::array<Ids, 3> between;
      for (; edge != divided.end() && edge->face == face; ++edge) {
        const Triangle& t = soup_.triangles[face];
        between[edge->k] = lines[edge->line].between(t[edge->k], t[(edge->k + 1) % 3]);
      }
      divide(face, between, result);
      refuse_too_many(result.triangles.size());
    }
    return result;
  }

 private:
  static void refuse_too_many(std::size_t triangles) {
    constexpr std::size_t kMost = std::size_t{1} << 30;
    if (triangles > kMost) {
      throw Error(Errc::limit_exceeded,
                  "the mesh cannot be repaired: more than 2^30 faces would be left when edges are "
                  "divided at the corners of faces without area");
    }
  }

  // Those that may have an edge of a degenerate one, and these, ascending.
  [[nodiscard]] std::vector<std::uint32_t> faces_near() const {
    std::vector<std::uint8_t> on_line(soup_.points.size(), 0);
    for (std::size_t face = 0; face < is_degenerate_.size(); ++face) {
      if (is_degenerate_[face]) {
        for (const std::uint32_t corner : soup_.triangles[face]) {
          on_line[corner] = 1;
        }
      }
    }
    return support::indices_where(soup_.triangles.size(), [&](std::uint32_t face) {
      const auto& [a, b, c] = soup_.triangles[face];
      return on_line[a] + on_line[b] + on_line[c] >= 2;
    });
  }

  [[nodiscard]] std::uint32_t face_of(std::uint32_t half_edge) const {
    return near_[half_edge / 3];
  }

  // Number of each degenerate face's line.
  [[nodiscard]] std::vector<std::uint32_t> number_lines() const {
    support::DisjointSets sets(is_degenerate_.size());
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const std::uint32_t* first = nullptr;
      for (const std::uint32_t& half_edge : edges_[i].half_edges) {
        if (is_degenerate_[face_of(half_edge)]) {
          first = first == nullptr ? &half_edge : first;
          sets.unite(face_of(*first), face_of(half_edge));
        }
      }
    }
    std::vector<std::uint32_t> number = sets.representatives();
    std::uint32_t next = 0;
    for (std::uint32_t face = 0; face < number.size(); ++face) {
      if (is_degenerate_[face]) {
        number[face] = number[face] == face ? next++ : number[number[face]];
      }
    }
    return number;
  }

  [[nodiscard]] std::vector<LinePoints> find_lines(std::span<const std::uint32_t> number) const {
    std::vector<std::vector<std::uint32_t>> corners;
    for (std::size_t face = 0; face < number.size(); ++face) {
      if (is_degenerate_[face]) {
        corners.resize(std::max<std::size_t>(corners.size(), number[face] + 1));
        const Triangle& t = soup_.triangles[face];
        corners[number[face]].insert(corners[number[face]].end(), t.begin(), t.end());
      }
    }
    std::vector<LinePoints> lines;
    lines.reserve(corners.size());
    for (std::vector<std::uint32_t>& of_line : corners) {
      lines.emplace_back(soup_.points, std::move(of_line));
    }
    return lines;
  }

  // By face.
  [[nodiscard]] std::vector<DividedEdge> find_divided_edges(
      std::span<const std::uint32_t> number) const {
    std::vector<DividedEdge> divided;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const auto along = edges_[i].half_edges;
      const auto degenerate = std::ranges::find_if(along, [this](std::uint32_t half_edge) {
        return is_degenerate_[face_of(half_edge)] != 0;
      });
      if (degenerate == along.end()) {
        continue;
      }
      for (const std::uint32_t half_edge : along) {
        if (const std::uint32_t face = face_of(half_edge); !is_degenerate_[face]) {
          divided.push_back({face, half_edge % 3, number[face_of(*degenerate)]});
        }
      }
    }
    std::ranges::sort(divided, {}, &DividedEdge::face);
    return divided;
  }

  // Adds the triangles that a face falls into, given the points on its edges. Copies of a face,
  // whichever way round, fall into the same.
  void divide(std::uint32_t face, const std::array<Ids, 3>& between, PolygonSoup& result) const {
    const Triangle& t = soup_.triangles[face];
    if (between[0].empty() && between[1].empty() && between[2].empty()) {
      result.triangles.push_back(t);
      result.sources.push_back(soup_.sources[face]);
      return;
    }
    const auto k = static_cast<std::size_t>(std::ranges::min_element(t) - t.begin());
    const bool is_turned = t[(k + 2) % 3] < t[(k + 1) % 3];
    Triangle corners = {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
    std::array<Ids, 3> on{between[k], between[(k + 1) % 3], between[(k + 2) % 3]};
    if (is_turned) {
      std::swap(corners[1], corners[2]);
      std::swap(on[0], on[2]);
      std::ranges::for_each(on, [](Ids& points) { std::ranges::reverse(points); });
    }
    const auto fan = [&](std::uint32_t apex, std::uint32_t from,
                         std::span<const std::uint32_t> line) {
      for (const std::uint32_t to : line) {
        result.triangles.push_back(is_turned ? Triangle{apex, to, from} : Triangle{apex, from, to});
        result.sources.push_back(soup_.sources[face]);
        from = to;
      }
    };
    // Each fan has its apex off the line of its points.
    auto& [on_ab, on_bc, on_ca] = on;
    const auto [a, b, c] = corners;
    on_ca.push_back(a);
    if (!on_ab.empty()) {
      on_bc.push_back(c);
      fan(c, on_ab.front(), std::span(on_ab).subspan(1));
      fan(on_ab.back(), b, on_bc);
      fan(on_ab.front(), c, on_ca);
    } else if (!on_bc.empty()) {
      fan(a, b, on_bc);
      fan(on_bc.back(), c, on_ca);
    } else {
      fan(b, c, on_ca);
    }
  }

  const PolygonSoup& soup_;
  support::BulkVector<std::uint8_t> is_degenerate_;
  std::vector<std::uint32_t> near_;
  std::vector<Triangle> triangles_near_;
  mesh::EdgeTable edges_;  // of these: its face i is near_[i]
};

}  // namespace

std::size_t drop_degenerate_faces(PolygonSoup& soup) {
  const std::size_t dropped = drop_faces_that_repeat_a_corner(soup);
  support::BulkVector<std::uint8_t> degenerate = degenerate_faces(soup);
  const auto count = static_cast<std::size_t>(std::ranges::count(degenerate, 1));
  if (count > 0) {
    soup = DegenerateFaces(soup, std::move(degenerate)).replaced();
  }
  return dropped + count;
}

}  // namespace dupin::healing
