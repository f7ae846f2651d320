#include "dupin/blends/regularity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "ringed/curvature_ratio.h"

namespace dupin {
namespace {

using numbers::Interval;
using ringed::CurvatureRatio;
using Leaf = CurvatureRatio::Leaf;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMaxDepth = 50;                // subinterval ends stay exact doubles
constexpr int kMaxProofDepth = 40;           // of the design's D.1
constexpr std::size_t kMaxSplits = 1 << 14;  // a fraction of a second; then what is proven is said

void append(std::vector<ParameterInterval>& intervals, const ParameterInterval& next) {
  if (!intervals.empty() && intervals.back().to == next.from) {
    intervals.back().to = next.to;
  } else {
    intervals.push_back(next);
  }
}

// Best-first search for the largest kappa R.
class LargestRatio {
 public:
  LargestRatio(const CurvatureRatio& ratio, double width) : ratio_(ratio), width_(width) {
    push(ratio.whole());
    for (std::size_t splits = 0; splits < kMaxSplits && improve(); ++splits) {
    }
  }

  [[nodiscard]] Regularity result() const {
    Regularity result;
    result.stops = stops_;
    std::sort(result.stops.begin(), result.stops.end(),
              [](const auto& a, const auto& b) { return a.from < b.from; });
    double most = attained_;
    ParameterInterval where{1, 0};
    for (const Entry& entry : heap_) {
      if (entry.range.upper >= attained_) {
        most = std::max(most, entry.range.upper);
        where = {std::min(where.from, entry.leaf.from), std::max(where.to, entry.leaf.to)};
      }
    }
    // Without curvature the margin is exactly 1.
    result.lower =
        most == 0 ? 1 : numbers::next_below(1 - numbers::sqrt(numbers::Interval(most)).upper);
    result.upper =
        std::min(1.0, numbers::next_above(1 - numbers::sqrt(numbers::Interval(attained_)).lower));
    result.minimum = where;
    if (!stops_.empty()) {
      result.lower = -kInfinity;
      result.minimum = result.stops.front();
    }
    return result;
  }

 private:
  struct Entry {
    Leaf leaf;
    Interval range;
  };

  static bool less(const Entry& a, const Entry& b) { return a.range.upper < b.range.upper; }

  void push(Leaf leaf) {
    for (const Interval& end : {ratio_.at_start(leaf), ratio_.at_end(leaf)}) {
      attained_ = std::max(attained_, end.lower);
    }
    const Interval range = ratio_.range(leaf);
    heap_.push_back({std::move(leaf), range});
    std::push_heap(heap_.begin(), heap_.end(), less);
  }

  // Splits the leaf that may hold the largest value; false when the bounds are close or cannot
  // come closer.
  bool improve() {
    if (heap_.empty()) {
      return false;
    }
    const Entry& front = heap_.front();
    const double most = std::sqrt(front.range.upper);
    const bool stops = most == kInfinity;
    if (!stops && most - std::sqrt(attained_) <= width_ * std::max(1.0, most)) {
      return false;
    }
    if (front.leaf.depth == kMaxDepth) {
      if (stops) {
        stops_.push_back({front.leaf.from, front.leaf.to});
        std::pop_heap(heap_.begin(), heap_.end(), less);
        heap_.pop_back();
      }
      return stops;
    }
    std::pop_heap(heap_.begin(), heap_.end(), less);
    const auto [left, right] = ratio_.split(heap_.back().leaf);
    heap_.pop_back();
    push(left);
    push(right);
    return true;
  }

  const CurvatureRatio& ratio_;
  double width_;
  double attained_ = 0;
  std::vector<Entry> heap_;
  std::vector<ParameterInterval> stops_;
};

void require_finite(double margin) {
  if (!std::isfinite(margin)) {
    throw Error(Errc::invalid_argument, "a margin to prove must be a finite number");
  }
}

std::vector<ParameterInterval> violations(const CurvatureRatio& ratio, double margin) {
  const double room = numbers::next_below(1 - margin);
  const double bound = margin == 0 ? 1 : numbers::next_below(room * room);

  std::vector<ParameterInterval> found;
  std::vector<Leaf> stack{ratio.whole()};
  std::size_t splits = 0;
  while (!stack.empty()) {
    const Leaf leaf = std::move(stack.back());
    stack.pop_back();
    const Interval range = ratio.range(leaf);
    if (range.upper < bound) {
      continue;
    }
    if (range.lower >= bound || leaf.depth == kMaxDepth || splits++ >= kMaxSplits) {
      append(found, {leaf.from, leaf.to});
      continue;
    }
    auto [left, right] = ratio.split(leaf);
    stack.push_back(std::move(right));
    stack.push_back(std::move(left));
  }
  return found;
}

}  // namespace

Regularity regularity(const RingedSurface& surface, const RegularityOptions& options) {
  if (!(options.width > 0)) {
    throw Error(Errc::invalid_argument, "the width of the margin's bounds must be positive, not " +
                                            decimal(options.width, kMessageDigits));
  }
  const CurvatureRatio ratio(surface);
  Regularity result = LargestRatio(ratio, options.width).result();
  if (!(result.lower > 0)) {
    result.folded = violations(ratio, 0);
  }
  return result;
}

std::vector<ParameterInterval> violations(const RingedSurface& surface, double margin) {
  require_finite(margin);
  return margin >= 1 ? std::vector{ParameterInterval{}}
                     : violations(CurvatureRatio(surface), margin);
}

std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, 3> kNames = {"proved", "refuted", "undecided"};
  return kNames.at(static_cast<std::size_t>(verdict));
}

MarginProof prove_margin(const RingedSurface& surface, double margin) {
  require_finite(margin);
  MarginProof proof;
  if (margin >= 1) {
    proof.verdict = Verdict::refuted;  // curvature is not negative
    return proof;
  }
  const CurvatureRatio ratio(surface);
  const mpq_class room = 1 - mpq_class(margin), bound = room * room;
  std::vector<Leaf> stack{ratio.whole()};
  for (std::size_t splits = 0; !stack.empty(); ++splits) {
    const Leaf leaf = std::move(stack.back());
    stack.pop_back();
    proof.depth = std::max(proof.depth, leaf.depth);
    if (ratio.proves_below(leaf, bound)) {
      ++proof.leaves;
      proof.proven.push_back({leaf.from, leaf.to});
      continue;
    }
    proof.where = {leaf.from, leaf.to};
    if (ratio.refutes_below(leaf, bound)) {
      proof.verdict = Verdict::refuted;
      return proof;
    }
    if (leaf.depth == kMaxProofDepth || splits == kMaxSplits) {
      return proof;
    }
    auto [left, right] = ratio.split(leaf);
    stack.push_back(std::move(right));
    stack.push_back(std::move(left));
  }
  proof.verdict = Verdict::proved;
  proof.where = {};
  return proof;
}

}  // namespace dupin
