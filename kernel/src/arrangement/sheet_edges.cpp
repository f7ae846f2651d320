#include "arrangement/sheet_edges.h"

#include <algorithm>
#include <atomic>

#include "arrangement/flat_sheets.h"
#include "support/blocks.h"
#include "support/sort_by_key.h"

namespace dupin::arrangement {
namespace {

struct Side {
  EdgeKey edge;
  std::uint32_t place;  // of its triangle
  Feature feature;
};

bool has_one_fan_around_an_end(const ArrangementInput& input, EdgeKey edge) {
  return !input.special[lower_end(edge)] || !input.special[upper_end(edge)];
}

}  // namespace

SheetEdges::SheetEdges(const ArrangementInput& input, std::span<const TrianglePair> in_plane)
    : place_(input.triangles.size(), kNone) {
  if (may_cross_themselves(input)) {
    return;
  }
  for (const TrianglePair& pair : in_plane) {
    place_[pair.first] = place_[pair.second] = 0;
  }
  const std::vector<std::uint32_t> triangles =
      support::indices_where(place_.size(), [this](std::size_t t) { return place_[t] != kNone; });
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    place_[triangles[i]] = i;
  }
  edges_.assign(triangles.size(), OfTriangle{kNone, kNone, kNone});
  const support::BulkVector<Side> sides = support::collect_by_key<Side>(
      triangles.size(),
      [&](std::size_t i, const auto& found) {
        for (Feature f = 3; f < kInside; ++f) {
          found(Side{edge_of(input.triangles[triangles[i]], f), static_cast<std::uint32_t>(i), f});
        }
      },
      static_cast<std::uint32_t>(input.points.size()),
      [](const Side& side) { return lower_end(side.edge); },
      [](const Side& a, const Side& b) { return a.edge < b.edge; });
  const auto pair_of = [&](const support::IndexRange& run) {
    return TrianglePair{triangles[sides[run.begin].place], triangles[sides[run.begin + 1].place]};
  };
  const std::vector<support::IndexRange> runs =
      support::ranges_of_equal(sides, [](const Side& side) { return side.edge; });
  const std::vector<std::uint32_t> inner = support::indices_where(runs.size(), [&](std::size_t r) {
    const UpwardRounding rounding;
    return runs[r].end - runs[r].begin == 2 &&
           has_one_fan_around_an_end(input, sides[runs[r].begin].edge) &&
           are_one_sheet(input, pair_of(runs[r]));
  });
  for (const std::uint32_t r : inner) {
    for (std::uint32_t i = runs[r].begin; i < runs[r].end; ++i) {
      edges_[sides[i].place][sides[i].feature - 3U] = static_cast<std::uint32_t>(inner_.size());
    }
    inner_.push_back({pair_of(runs[r]), 0});
  }
}

bool SheetEdges::cross(std::uint32_t first, std::size_t first_edge, std::uint32_t second,
                       std::size_t second_edge) {
  if (inner_.empty()) {
    return false;
  }
  const std::uint32_t a = number(first, first_edge);
  const std::uint32_t b = a != kNone ? number(second, second_edge) : kNone;
  if (b == kNone) {
    return false;
  }
  for (const std::uint32_t edge : {a, b}) {
    std::atomic_ref(inner_[edge].is_crossed).store(1, std::memory_order_relaxed);
  }
  return true;
}

std::vector<TrianglePair> SheetEdges::crossed() const {
  std::vector<TrianglePair> pairs;
  for (const Inner& edge : inner_) {
    if (edge.is_crossed) {
      pairs.push_back(edge.sides);
    }
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace dupin::arrangement
