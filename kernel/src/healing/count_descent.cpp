#include "healing/count_descent.h"

#include <array>
#include <cstdint>
#include <cstdlib>

namespace dupin::healing {
namespace {

class Descent {
 public:
  Descent(const mesh::EdgeTable& edges, std::span<const CountRange> ranges)
      : edges_(edges),
        ranges_(ranges),
        edge_of_(3 * ranges.size()),
        balance_(edges.size(), 0),
        steps_(kStepsPerTriangle * (ranges.size() + 1)) {
    for (const CountRange& range : ranges) {
      counts_.push_back(range.given);
    }
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      for (const std::uint32_t half_edge : edges[e].half_edges) {
        edge_of_[half_edge] = e;
        balance_[e] += std::int64_t{way(half_edge)} * counts_[half_edge / 3];
      }
    }
  }

  std::vector<int> run() {
    for (std::uint32_t e = 0; e < balance_.size(); ++e) {
      if (balance_[e] != 0) {
        look_around(e);
      }
    }
    while (!queue_.empty() && steps_ > 0) {
      const std::uint32_t t = queue_.back();
      queue_.pop_back();
      improve(t);
    }
    return std::move(counts_);
  }

 private:
  static constexpr std::size_t kStepsPerTriangle = 64;

  [[nodiscard]] int way(std::uint32_t half_edge) const {
    return edges_.origin(half_edge) < edges_.target(half_edge) ? 1 : -1;
  }

  void look_around(std::uint32_t e) {
    for (const std::uint32_t half_edge : edges_[e].half_edges) {
      if (steps_ == 0) {
        return;
      }
      --steps_;
      queue_.push_back(half_edge / 3);
    }
  }

  // What would be missing at the triangle's edges after a change of its count.
  [[nodiscard]] std::int64_t missing(std::uint32_t t, std::int64_t change) const {
    std::int64_t sum = 0;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      sum += std::abs(balance_[edge_of_[h]] + way(h) * change);
    }
    return sum;
  }

  [[nodiscard]] bool is_allowed(std::uint32_t t, std::int64_t count) const {
    const std::int64_t size = std::abs(count);
    return size >= ranges_[t].least && size <= ranges_[t].most;
  }

  void improve(std::uint32_t t) {
    std::int64_t best = 0;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      const std::int64_t change = -way(h) * balance_[edge_of_[h]];
      if (is_allowed(t, counts_[t] + change) && missing(t, change) < missing(t, best)) {
        best = change;
      }
    }
    if (best == 0) {
      return;
    }
    counts_[t] += static_cast<int>(best);
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      balance_[edge_of_[h]] += way(h) * best;
      if (balance_[edge_of_[h]] != 0) {
        look_around(edge_of_[h]);
      }
    }
  }

  const mesh::EdgeTable& edges_;
  std::span<const CountRange> ranges_;
  std::vector<int> counts_;
  std::vector<std::uint32_t> edge_of_;  // of each half-edge
  std::vector<std::int64_t> balance_;   // of each edge
  std::size_t steps_;
  std::vector<std::uint32_t> queue_;
};

}  // namespace

std::vector<int> descended_counts(const mesh::EdgeTable& edges,
                                  std::span<const CountRange> ranges) {
  return Descent(edges, ranges).run();
}

}  // namespace dupin::healing
