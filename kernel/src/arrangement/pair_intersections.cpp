#include "arrangement/pair_intersections.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "arrangement/sheet_edges.h"
#include "support/blocks.h"

namespace dupin::arrangement {
namespace {

// What one task has found.
struct Batch {
  struct InPlane {
    TrianglePair pair;
    std::size_t place;  // among what is found of others
  };
  std::vector<TriangleIntersection> found;
  std::vector<InPlane> in_plane;
};

std::vector<TrianglePair> pairs_in_plane(const std::vector<Batch>& batches) {
  std::vector<TrianglePair> pairs;
  for (const Batch& batch : batches) {
    std::ranges::transform(batch.in_plane, std::back_inserter(pairs), &Batch::InPlane::pair);
  }
  return pairs;
}

void add_those_in_plane(const ArrangementInput& input, SheetEdges& sheets, Batch& batch) {
  if (batch.in_plane.empty()) {
    return;
  }
  const UpwardRounding rounding;
  const std::vector<TriangleIntersection> others = std::exchange(batch.found, {});
  auto next = others.begin();
  for (const auto& [pair, place] : batch.in_plane) {
    const auto end = others.begin() + static_cast<std::ptrdiff_t>(place);
    batch.found.insert(batch.found.end(), next, end);
    next = end;
    const auto is_inside = [&sheets, pair = pair](std::size_t e, std::size_t f) {
      return sheets.cross(pair.first, e, pair.second, f);
    };
    intersect_in_plane(input, pair.first, pair.second, is_inside, batch.found);
  }
  batch.found.insert(batch.found.end(), next, others.end());
  support::release(batch.in_plane);
}

}  // namespace

Intersections find_intersections(const ArrangementInput& input,
                                 std::span<const TrianglePair> candidates,
                                 const support::ProgressStage& stage) {
  constexpr std::size_t kBatch = 512;
  std::vector<Batch> batches(support::block_count(candidates.size(), kBatch));
  support::for_each_block(
      candidates.size(),
      [&](const support::Block& block) {
        const UpwardRounding rounding;
        auto& [found, in_plane] = batches[block.number];
        for (const TrianglePair& pair : candidates.subspan(block.begin, block.end - block.begin)) {
          if (!intersect_across(input, pair.first, pair.second, found)) {
            in_plane.push_back({pair, found.size()});
          }
        }
        stage.step(batches.size());
      },
      kBatch);
  Intersections result;
  if (const std::vector<TrianglePair> in_plane = pairs_in_plane(batches); !in_plane.empty()) {
    SheetEdges sheets(input, in_plane);
    support::for_each_in_parallel(
        batches.size(), [&](std::size_t i) { add_those_in_plane(input, sheets, batches[i]); });
    result.crossed_sheets = sheets.crossed();
  }
  std::vector<std::vector<TriangleIntersection>> lists;
  lists.reserve(batches.size());
  for (Batch& batch : batches) {
    lists.push_back(std::move(batch.found));
  }
  result.found = support::joined(std::move(lists));
  return result;
}

}  // namespace dupin::arrangement
