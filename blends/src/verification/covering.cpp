#include "verification/covering.h"

#include <algorithm>
#include <cstddef>

namespace dupin::verification {
namespace {

// How many leaves lie over each cell of a line, and the least of these counts.
class Counts {
 public:
  explicit Counts(std::size_t cells) {
    while (width_ < cells) {
      width_ *= 2;
    }
    added_.resize(2 * width_);
    least_.resize(2 * width_);
  }

  void add(std::size_t from, std::size_t to, int change) { add(1, 0, width_, from, to, change); }

  [[nodiscard]] int least(std::size_t from, std::size_t to) const {
    return least(1, 0, width_, from, to);
  }

 private:
  void add(std::size_t node, std::size_t begin, std::size_t end, std::size_t from, std::size_t to,
           int change) {
    if (to <= begin || end <= from) {
      return;
    }
    if (from <= begin && end <= to) {
      added_[node] += change;
      least_[node] += change;
      return;
    }
    const std::size_t middle = (begin + end) / 2;
    add(2 * node, begin, middle, from, to, change);
    add(2 * node + 1, middle, end, from, to, change);
    least_[node] = added_[node] + std::min(least_[2 * node], least_[2 * node + 1]);
  }

  [[nodiscard]] int least(std::size_t node, std::size_t begin, std::size_t end, std::size_t from,
                          std::size_t to) const {
    if (from <= begin && end <= to) {
      return least_[node];
    }
    const std::size_t middle = (begin + end) / 2;
    if (to <= middle) {
      return added_[node] + least(2 * node, begin, middle, from, to);
    }
    if (middle <= from) {
      return added_[node] + least(2 * node + 1, middle, end, from, to);
    }
    return added_[node] + std::min(least(2 * node, begin, middle, from, to),
                                   least(2 * node + 1, middle, end, from, to));
  }

  std::size_t width_ = 1;
  std::vector<int> added_, least_;
};

// Where a leaf begins or ends to lie over the sweeping line of equal first parameters.
struct Event {
  double at;
  int change;
  const ParameterInterval* over;
};

std::size_t index_of(const std::vector<double>& cuts, double t) {
  return std::size_t(std::lower_bound(cuts.begin(), cuts.end(), t) - cuts.begin());
}

}  // namespace

// Between two neighbouring events the leaves over the line are the same. In the ordered case, cells
// of the second parameter that lie above the strip's beginning at all are asked for.
bool covered(const ParameterInterval& first, const ParameterInterval& second,
             const std::vector<DiscPairs>& leaves, bool ordered) {
  std::vector<double> cuts{second.from, second.to};
  std::vector<Event> events;
  for (const DiscPairs& leaf : leaves) {
    if (leaf.first.from < leaf.first.to && leaf.second.from < leaf.second.to) {
      events.push_back({leaf.first.from, 1, &leaf.second});
      events.push_back({leaf.first.to, -1, &leaf.second});
      cuts.push_back(leaf.second.from);
      cuts.push_back(leaf.second.to);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  std::sort(events.begin(), events.end(),
            [](const Event& a, const Event& b) { return a.at < b.at; });
  Counts counts(cuts.size() - 1);
  const std::size_t lowest = index_of(cuts, second.from), highest = index_of(cuts, second.to);
  double reached = first.from;
  for (auto event = events.begin(); event != events.end() && reached < first.to;) {
    const double at = event->at;
    if (at > reached) {
      // The last cell that begins at or below the strip's beginning is cut by the diagonal.
      const auto above = std::upper_bound(cuts.begin(), cuts.end(), reached) - cuts.begin();
      const std::size_t from =
          ordered ? std::max(lowest, above > 0 ? std::size_t(above - 1) : 0) : lowest;
      if (from < highest && counts.least(from, highest) < 1) {
        return false;
      }
      reached = at;
    }
    for (; event != events.end() && event->at == at; ++event) {
      counts.add(index_of(cuts, event->over->from), index_of(cuts, event->over->to), event->change);
    }
  }
  return reached >= first.to;
}

}  // namespace dupin::verification
