#include "mesh/edge_table.h"

#include <algorithm>
#include <numeric>

#include "support/disjoint_sets.h"

namespace dupin::mesh {

EdgeTable::EdgeTable(std::span<const Triangle> triangles, std::size_t point_count)
    : triangles_(triangles), half_edges_(3 * triangles.size()) {
  const auto low = [&](std::uint32_t h) { return std::min(origin(h), target(h)); };
  const auto high = [&](std::uint32_t h) { return std::max(origin(h), target(h)); };
  std::vector<std::uint32_t> begin(point_count + 1);
  const auto count = static_cast<std::uint32_t>(half_edges_.size());
  for (std::uint32_t h = 0; h < count; ++h) {
    ++begin[low(h) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
  for (std::uint32_t h = 0; h < count; ++h) {
    half_edges_[end[low(h)]++] = h;
  }
  starts_.reserve(half_edges_.size() / 2 + 1);
  for (std::size_t point = 0; point < point_count; ++point) {
    std::sort(half_edges_.begin() + begin[point], half_edges_.begin() + begin[point + 1],
              [&](std::uint32_t g, std::uint32_t h) {
                const std::uint32_t to_g = high(g), to_h = high(h);
                return to_g != to_h ? to_g < to_h : g < h;
              });
    for (std::uint32_t i = begin[point]; i < begin[point + 1]; ++i) {
      if (i == begin[point] || high(half_edges_[i]) != high(half_edges_[i - 1])) {
        starts_.push_back(i);
      }
    }
  }
  starts_.push_back(count);
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
                                        std::span<const std::uint32_t> fans) {
  std::vector<std::int64_t> numbers(shells.count);
  for (const std::uint32_t shell : shells.of_face) {
    ++numbers[shell];
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    --numbers[shells.of_face[edges[i].half_edges[0] / 3]];
  }
  for (std::uint32_t corner = 0; corner < fans.size(); ++corner) {
    numbers[shells.of_face[corner / 3]] += fans[corner] == corner ? 1 : 0;
  }
  return numbers;
}

}  // namespace dupin::mesh
