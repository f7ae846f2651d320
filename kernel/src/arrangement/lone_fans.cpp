#include "arrangement/lone_fans.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "support/blocks.h"
#include "support/bulk_vector.h"

namespace dupin::arrangement {
namespace {

// Around points with more triangles the walk, which is quadratic, takes longer than it saves.
constexpr std::size_t kMost = 64;

// The other corners of a triangle, in its order.
struct Spoke {
  PointId from, to;
};

// Whether spokes follow each other in one circle: no two leave from the same point, and a walk gets
// to all of them.
bool is_lone_fan(std::span<const Spoke> spokes) {
  if (spokes.empty() || spokes.size() > kMost) {
    return false;
  }
  PointId at = spokes.front().from;
  for (std::size_t step = 0; step < spokes.size(); ++step) {
    const auto leaves = [at](const Spoke& spoke) { return spoke.from == at; };
    const auto onward = std::ranges::find_if(spokes, leaves);
    if (onward == spokes.end() || std::find_if(onward + 1, spokes.end(), leaves) != spokes.end() ||
        (step > 0 && at == spokes.front().from)) {
      return false;
    }
    at = onward->to;
  }
  return at == spokes.front().from;
}

}  // namespace

void mark_all_but_lone_fans(ArrangementInput& input) {
  support::BulkVector<std::uint32_t> first(input.points.size() + 1, 0);
  for (const Triangle& corners : input.triangles) {
    for (const PointId corner : corners) {
      ++first[corner + 1];
    }
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  support::BulkVector<Spoke> spokes(first.back());
  support::BulkVector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t t = 0; t < input.triangles.size(); ++t) {
    const Triangle& corners = input.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      spokes[next[corners[i]]++] = {corners[(i + 1) % 3], corners[(i + 2) % 3]};
      input.special[corners[i]] |= input.crossing[t];
    }
  }
  support::for_each_block(input.points.size(), [&](const support::Block& block) {
    for (std::size_t p = block.begin; p < block.end; ++p) {
      if (input.special[p] == 0 &&
          !is_lone_fan(std::span(spokes).subspan(first[p], first[p + 1] - first[p]))) {
        input.special[p] = 1;
      }
    }
  });
}

}  // namespace dupin::arrangement
