#include "mesh/edge_table.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>
#include <utility>
#include <vector>

#include "support/blocks.h"
#include "support/disjoint_sets.h"
#include "support/none.h"

namespace dupin::mesh {

namespace {

/// Sorts half-edges of one lower end by their higher ends, then by number, and appends where, of
/// all half-edges, those of each edge start; the first is at `from`.
void sort_around(std::span<std::uint32_t> half_edges, const EdgeTable& edges, std::uint32_t from,
                 std::vector<std::uint32_t>& starts) {
  constexpr std::size_t kUsual = 64;
  std::array<std::uint64_t, kUsual> few;
  std::vector<std::uint64_t> many(half_edges.size() > kUsual ? half_edges.size() : 0);
  const std::span<std::uint64_t> keys(many.empty() ? few.data() : many.data(), half_edges.size());
  std::ranges::transform(half_edges, keys.begin(), [&](std::uint32_t h) {
    return std::uint64_t(std::max(edges.origin(h), edges.target(h))) << 32 | h;
  });
  std::ranges::sort(keys);
  for (std::uint32_t i = 0; i < keys.size(); ++i) {
    half_edges[i] = static_cast<std::uint32_t>(keys[i]);
    if (i == 0 || keys[i] >> 32 != keys[i - 1] >> 32) {
      starts.push_back(from + i);
    }
  }
}

}  // namespace

// Threads put half-edges to their lower ends in any order, which sorting takes back.
EdgeTable::EdgeTable(std::span<const Triangle> triangles, std::size_t point_count)
    : triangles_(triangles), half_edges_(3 * triangles.size()) {
  std::vector<std::uint32_t> begin(point_count + 1);
  const auto for_each_half_edge = [&](const auto& visit) {
    support::for_each_block(triangles.size(), [&](const support::Block& block) {
      for (std::size_t f = block.begin; f < block.end; ++f) {
        const Triangle& t = triangles[f];
        const auto h = static_cast<std::uint32_t>(3 * f);
        visit(h, std::min(t[0], t[1]));
        visit(h + 1, std::min(t[1], t[2]));
        visit(h + 2, std::min(t[2], t[0]));
      }
    });
  };
  const auto next_at = [&](std::uint32_t point) {
    return std::atomic_ref(begin[point]).fetch_add(1, std::memory_order_relaxed);
  };
  for_each_half_edge([&](std::uint32_t, std::uint32_t low) { next_at(low); });
  std::exclusive_scan(begin.begin(), begin.end(), begin.begin(), 0U);
  for_each_half_edge([&](std::uint32_t h, std::uint32_t low) { half_edges_[next_at(low)] = h; });
  // Now where those of the next point begin.
  starts_ = support::collect_in_order<std::uint32_t>(
      point_count, [&](std::size_t point, std::vector<std::uint32_t>& starts) {
        const std::uint32_t from = point == 0 ? 0 : begin[point - 1];
        sort_around(std::span(half_edges_).subspan(from, begin[point] - from), *this, from, starts);
      });
  starts_.push_back(static_cast<std::uint32_t>(half_edges_.size()));
}

Edge EdgeTable::operator[](std::size_t edge) const {
  const std::span<const std::uint32_t> along =
      std::span(half_edges_).subspan(starts_[edge], starts_[edge + 1] - starts_[edge]);
  const std::uint32_t a = origin(along[0]), b = target(along[0]);
  return {std::min(a, b), std::max(a, b), along};
}

std::vector<std::uint32_t> corner_fans(std::span<const Triangle> triangles,
                                       const EdgeTable& edges) {
  support::DisjointSets fans(3 * triangles.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge edge = edges[i];
    const auto corner_at = [&](std::uint32_t half_edge, std::uint32_t point) {
      return edges.origin(half_edge) == point ? half_edge : next_half_edge(half_edge);
    };
    for (const std::uint32_t half_edge : edge.half_edges.subspan(1)) {
      for (const std::uint32_t point : {edge.low, edge.high}) {
        fans.unite(corner_at(edge.half_edges[0], point), corner_at(half_edge, point));
      }
    }
  }
  return fans.representatives();
}

Shells shells(std::size_t face_count, const EdgeTable& edges) {
  support::DisjointSets sets(face_count);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge edge = edges[i];
    for (const std::uint32_t half_edge : edge.half_edges.subspan(1)) {
      sets.unite(edge.half_edges[0] / 3, half_edge / 3);
    }
  }
  return grouped(sets.representatives());
}

Shells shells_by_points(std::span<const Triangle> triangles,
                        std::span<const std::uint32_t> component) {
  std::vector<std::uint32_t> first(component.size(), support::kNone), lowest;
  lowest.reserve(triangles.size());
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    std::uint32_t& face = first[component[triangles[f][0]]];
    face = std::min(face, f);
    lowest.push_back(face);
  }
  return grouped(std::move(lowest));
}

Shells grouped(std::vector<std::uint32_t> lowest_faces) {
  const auto face_count = static_cast<std::uint32_t>(lowest_faces.size());
  Shells result;
  result.of_face = std::move(lowest_faces);
  result.starts.push_back(0);
  for (std::uint32_t face = 0; face < face_count; ++face) {
    const std::uint32_t lowest = result.of_face[face];
    if (lowest == face) {
      result.of_face[face] = static_cast<std::uint32_t>(result.count++);
      result.starts.push_back(0);
    } else {
      result.of_face[face] = result.of_face[lowest];
    }
    ++result.starts[result.of_face[face] + 1];
  }
  std::partial_sum(result.starts.begin(), result.starts.end(), result.starts.begin());
  std::vector<std::uint32_t> end(result.starts.begin(), result.starts.end() - 1);
  result.faces.resize(face_count);
  for (std::uint32_t face = 0; face < face_count; ++face) {
    result.faces[end[result.of_face[face]]++] = face;
  }
  return result;
}

std::vector<std::int64_t> euler_numbers(const Shells& shells, const EdgeTable& edges,
                                        std::span<const std::uint32_t> fans,
                                        const Counted& counted) {
  std::vector<std::int64_t> numbers(shells.count);
  for (std::uint32_t face = 0; face < shells.of_face.size(); ++face) {
    numbers[shells.of_face[face]] += counted.face(face) ? 1 : 0;
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge edge = edges[i];
    numbers[shells.of_face[edge.half_edges[0] / 3]] -= counted.point(edge.low) ? 1 : 0;
  }
  for (std::uint32_t corner = 0; corner < fans.size(); ++corner) {
    const bool is_fan = fans[corner] == corner && counted.point(edges.origin(corner));
    numbers[shells.of_face[corner / 3]] += is_fan ? 1 : 0;
  }
  return numbers;
}

}  // namespace dupin::mesh
