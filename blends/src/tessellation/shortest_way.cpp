#include "tessellation/shortest_way.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <ranges>
#include <tuple>

namespace dupin::tessellation {
namespace {

enum class Towards { above, below };

// A step, by how long the way is with it: at least, unless it is measured.
struct Candidate {
  double length;
  std::size_t to, from;
  bool is_measured;
  Towards towards;    // those among which it is
  std::size_t place;  // among them

  bool operator>(const Candidate& other) const {
    return std::tie(length, to, from) > std::tie(other.length, other.to, other.from);
  }
};

class Search {
 public:
  Search(const std::vector<HeightRange>& places, const StepLength& step)
      : places_(places),
        step_(step),
        by_low_(places.size()),
        by_high_(places.size()),
        before_(places.size(), 0),
        length_(places.size(), 0),
        is_reached_(places.size(), false) {
    std::iota(by_low_.begin(), by_low_.end(), 0);
    std::iota(by_high_.begin(), by_high_.end(), 0);
    std::ranges::stable_sort(by_low_, {}, [&](std::size_t i) { return places[i].low; });
    std::ranges::stable_sort(by_high_, {}, [&](std::size_t i) { return -places[i].high; });
  }

  std::vector<std::size_t> run() {
    reach(0, 0);
    while (!candidates_.empty() && !is_reached_[1]) {
      const Candidate next = candidates_.top();
      candidates_.pop();
      if (!next.is_measured) {
        push_next(next.from, next.towards, next.place + 1);
      }
      if (is_reached_[next.to]) {
        continue;
      }
      if (next.is_measured) {
        before_[next.to] = next.from;
        reach(next.to, next.length);
      } else if (const auto length = step_(next.from, next.to)) {
        Candidate measured = next;
        measured.length = length_[next.from] + *length;
        measured.is_measured = true;
        candidates_.push(measured);
      }
    }
    std::vector<std::size_t> way;
    for (std::size_t i = 1; is_reached_[1] && i != 0; i = before_[i]) {
      way.push_back(i);
    }
    std::ranges::reverse(way);
    return way;
  }

 private:
  void reach(std::size_t at, double length) {
    is_reached_[at] = true;
    length_[at] = length;
    const auto above = std::ranges::lower_bound(by_low_, places_[at].low, {},
                                                [&](std::size_t i) { return places_[i].low; });
    push_next(at, Towards::above, std::size_t(above - by_low_.begin()));
    push_next(at, Towards::below, 0);
  }

  // In either order the differences of heights do not decrease: one candidate stands for the rest.
  void push_next(std::size_t from, Towards towards, std::size_t place) {
    const auto& order = towards == Towards::above ? by_low_ : by_high_;
    const HeightRange& here = places_[from];
    for (; place < order.size(); ++place) {
      const HeightRange& there = places_[order[place]];
      if (is_reached_[order[place]] || (there.low >= here.low) != (towards == Towards::above)) {
        continue;
      }
      const double rise = towards == Towards::above ? there.low - here.high : here.low - there.high;
      candidates_.push(
          {length_[from] + std::max(rise, 0.0), order[place], from, false, towards, place});
      return;
    }
  }

  const std::vector<HeightRange>& places_;
  const StepLength& step_;
  std::vector<std::size_t> by_low_, by_high_, before_;
  std::vector<double> length_;
  std::vector<bool> is_reached_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> candidates_;
};

}  // namespace

std::vector<std::size_t> shortest_way(const std::vector<HeightRange>& places,
                                      const StepLength& step) {
  return Search(places, step).run();
}

}  // namespace dupin::tessellation
