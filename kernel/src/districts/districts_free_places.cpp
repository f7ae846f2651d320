#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/districts.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/vec.h"
#include "support/disjoint_sets.h"

namespace dupin {
namespace {

// Of Cuttable::clear: a place needs so much room.
constexpr double kLeastRoom = 1. / 16;

// Of one item.
constexpr double kMostPlanes = 1e6;

// Of what a group may weigh: less is no group of its own.
constexpr double kLittle = 1. / 32;

// Cells between the first planes, for each piece that is wanted.
constexpr double kCells = 4;

// So often planes come closer.
constexpr int kMostRounds = 6;

/// So far apart planes across all three axes are that cut the box into at least so many cells, and
/// not many more.
double plane_distance(const Eigen::AlignedBox3d& box, double cells) {
  constexpr double kStep = 1.25;
  constexpr int kMostSteps = 64;
  const Vec3 size = box.sizes();
  double distance = size.maxCoeff();
  for (int i = 0; i < kMostSteps && (size.array() / distance).ceil().max(1).prod() < cells; ++i) {
    distance /= kStep;
  }
  return distance;
}

void require_cuttable(const std::vector<std::optional<Cuttable>>& items, std::size_t boxes) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    const bool is_cuttable =
        !items[i] ||
        (i < boxes && items[i]->axis >= 0 && items[i]->axis < 3 && std::isfinite(items[i]->from) &&
         std::isfinite(items[i]->to) && std::isfinite(items[i]->clear));
    if (!is_cuttable) {
      throw Error(Errc::invalid_argument,
                  "item " + std::to_string(i) +
                      " needs a box, an axis from 0 to 2, and ends and room that are finite");
    }
  }
}

/// Of an axis. Those that overlap are one, so that there are few of many things in one place.
class TakenRanges {
 public:
  struct Range {
    double from, to;
  };

  void add(double from, double to) {
    constexpr std::size_t kFew = 64;
    ranges_.push_back({from, to});
    if (ranges_.size() > 2 * joined_ + kFew) {
      join();
    }
  }

  /// Ascending and apart.
  [[nodiscard]] const std::vector<Range>& joined() {
    join();
    return ranges_;
  }

 private:
  void join() {
    std::ranges::sort(ranges_, {}, &Range::from);
    std::vector<Range> result;
    for (const Range& range : ranges_) {
      if (result.empty() || range.from > result.back().to) {
        result.push_back(range);
      } else {
        result.back().to = std::max(result.back().to, range.to);
      }
    }
    ranges_ = std::move(result);
    joined_ = ranges_.size();
  }

  std::vector<Range> ranges_;
  std::size_t joined_ = 0;
};

}  // namespace

FreePlaces::FreePlaces(std::span<const Eigen::AlignedBox3d> boxes,
                       const std::vector<std::optional<Cuttable>>& items)
    : items_(items.size()) {
  require_numbers(boxes);
  require_cuttable(items, boxes.size());
  std::vector<TakenRanges> taken(items.size());
  const auto margin = [&](std::uint32_t i) {
    return items[i]->from - boxes[i].min()[items[i]->axis];
  };
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    if (items[i]) {
      const auto& [axis, from, to, clear] = *items[i];
      taken[i].add(boxes[i].min()[axis], from + clear);
      taken[i].add(to - clear, boxes[i].max()[axis]);
      items_[i] = {from, to, clear};
      box_.extend(boxes[i]);
    }
  }
  for_each_touching(boxes, [&](std::uint32_t a, std::uint32_t b) {
    for (const auto& [own, other] : {std::pair(a, b), std::pair(b, a)}) {
      if (own < items.size() && items[own]) {
        const int axis = items[own]->axis;
        taken[own].add(boxes[other].min()[axis] - margin(own),
                       boxes[other].max()[axis] + margin(own));
      }
    }
  });
  for (std::size_t i = 0; i < taken.size(); ++i) {
    const auto& ranges = taken[i].joined();
    for (std::size_t k = 1; k < ranges.size(); ++k) {
      const double end = ranges[k - 1].to;
      if (ranges[k].from - end > kLeastRoom * items_[i].clear) {
        items_[i].free.push_back({end, ranges[k].from});
      }
    }
  }
}

FreePlaces::Cuts FreePlaces::cuts(double distance) const {
  if (!(distance > 0 && std::isfinite(distance))) {
    throw Error(Errc::invalid_argument,
                "planes to cut at are a distance apart that is positive "
                "and finite, not " +
                    decimal(distance, kMessageDigits));
  }
  Cuts result;
  result.reserve(items_.size());
  for (const Item& item : items_) {
    result.push_back(item.free.empty() ? std::vector<double>() : cuts_of(item, distance));
  }
  return result;
}

std::vector<double> FreePlaces::cuts_of(const Item& item, double distance) {
  const auto place_in = [&](const Range& range, double plane) {
    const double clear = std::min((range.to - range.from) / 2, item.clear);
    return std::clamp(plane, range.from + clear, range.to - clear);
  };
  std::vector<double> places;
  std::size_t next = 0;  // the range that the plane is in, or before
  const double first = std::floor(item.from / distance) + 1,
               count = std::min((item.to - item.from) / distance + 1, kMostPlanes);
  for (int i = 0; i < count; ++i) {
    const double plane = (first + i) * distance;
    if (plane >= item.to) {
      break;
    }
    while (next + 1 < item.free.size() && item.free[next].to < plane) {
      ++next;
    }
    double place = place_in(item.free[next], plane);
    if (next > 0) {
      const double before = place_in(item.free[next - 1], plane);
      place = std::abs(before - plane) < std::abs(place - plane) ? before : place;
    }
    const bool is_apart = places.empty() || place > places.back() + item.clear;
    if (std::abs(place - plane) <= distance / 2 && is_apart) {
      places.push_back(place);
    }
  }
  return places;
}

FreePlaces::Cuts FreePlaces::best_cuts(double size, double most,
                                       const std::function<double(const Cuts&)>& largest) const {
  Cuts best;
  double least = size;
  double distance = box_.isEmpty() ? 0 : plane_distance(box_, kCells * std::ceil(size / most));
  for (int round = 0; round < kMostRounds && least > most && distance > 0; ++round) {
    Cuts tried = cuts(distance);
    const double left = largest(tried);
    if (left < least) {
      least = left;
      best = std::move(tried);
    }
    distance /= 2;
  }
  return best;
}

std::vector<std::uint32_t> grouped(std::vector<double> weights,
                                   std::span<const std::array<std::uint32_t, 2>> pairs,
                                   double most) {
  const auto is_there = [&](const auto& pair) { return std::ranges::max(pair) < weights.size(); };
  if (!std::ranges::none_of(weights, [](double weight) { return std::isnan(weight); }) ||
      std::isnan(most) || !std::ranges::all_of(pairs, is_there)) {
    throw Error(Errc::invalid_argument,
                "what is grouped needs weights that are numbers, and pairs of what has one");
  }
  support::DisjointSets groups(weights.size());
  for (const bool is_last : {false, true}) {
    for (const auto& [a, b] : pairs) {
      const std::uint32_t one = groups.find(a), other = groups.find(b);
      const bool fits = weights[one] + weights[other] <= most,
                 is_little = std::min(weights[one], weights[other]) < kLittle * most;
      if (one != other && (fits || (is_last && is_little))) {
        weights[std::min(one, other)] = weights[one] + weights[other];
        groups.unite(one, other);
      }
    }
  }
  return groups.representatives();
}

}  // namespace dupin
