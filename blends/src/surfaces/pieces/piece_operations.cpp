#include "surfaces/pieces/piece_operations.h"

#include <algorithm>
#include <cmath>

#include "numbers/mpfi_interval.h"

namespace dupin::surfaces {

namespace {

// Few digits, rounded down.
double shortened(double margin) {
  constexpr double kDigits = 0x1p20;
  return std::max(0.0, std::floor(margin * kDigits) / kDigits);
}

// On shorter stretches where the whole one tells nothing.
double margin_within(const ParameterInterval& t, const MarginOver& bound) {
  constexpr double kShortest = 0x1p-12;
  const double margin = bound(t);
  if (margin > 0 || t.to - t.from < kShortest) {
    return margin;
  }
  const auto [before, after] = halves(t);
  return std::min(margin_within(before, bound), margin_within(after, bound));
}

}  // namespace

MovingRing leaving_canal(const Ring& ring) {
  return along_canal({ring.center, ring.normal, ring.radius}, ring.slope, 1);
}

double nearly_largest_margin(const std::vector<RingedSurface>& tubes) {
  constexpr double kRoom = 0x1p-12;
  double least = 1;
  for (const RingedSurface& tube : tubes) {
    least = std::min(least, regularity(tube, {kRoom}).lower - kRoom);
  }
  return shortened(least);
}

// All radii have to keep the margin; leaves are cut where any has a leaf's end.
ProvedStretches prove_margin(const std::vector<RingedSurface>& tubes, double margin) {
  ProvedStretches result;
  std::vector<double> ends;
  for (const RingedSurface& tube : tubes) {
    const MarginProof proof = dupin::prove_margin(tube, margin);
    if (proof.verdict != Verdict::proved || !(smallest_radius(tube.radius) > 0)) {
      const bool refuted = proof.verdict == Verdict::refuted && tubes.size() == 1;
      return {refuted ? Verdict::refuted : Verdict::undecided, {}, proof.where};
    }
    for (const ParameterInterval& leaf : proof.proven) {
      ends.insert(ends.end(), {leaf.from, leaf.to});
    }
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    result.leaves.push_back({ends[i], ends[i + 1]});
  }
  return result;
}

// Bounds of a piece that no polynomial gives exactly are wide, so that there is more room where
// stretches shall be long.
double nearly_largest_margin(const MarginOver& bound) {
  constexpr double kShare = 1 - 0x1p-5;
  constexpr int kCells = 256;
  double least = 1;
  for (int i = 0; i < kCells; ++i) {
    least = std::min(least, margin_within({double(i) / kCells, (i + 1.0) / kCells}, bound));
  }
  return shortened(least * kShare);
}

ProvedStretches prove_margin(const MarginOver& bound, double margin) {
  constexpr double kShortest = 0x1p-12;
  ProvedStretches result;
  std::vector<ParameterInterval> stack{{0, 1}};
  while (!stack.empty()) {
    const ParameterInterval t = stack.back();
    stack.pop_back();
    if (bound(t) > margin) {
      result.leaves.push_back(t);
      continue;
    }
    if (t.to - t.from < kShortest) {
      return {Verdict::undecided, {}, t};
    }
    const auto [before, after] = halves(t);
    stack.push_back(after);
    stack.push_back(before);
  }
  return result;
}

double margin_of(const std::optional<DiscPace>& pace) {
  return pace && pace->advance > 0 && pace->radius.lower > 0
             ? (numbers::Interval(1) -
                numbers::Interval(pace->radius.upper) * pace->turning / pace->advance)
                   .lower
             : -1;
}

numbers::IntervalVec EndRing::travel() const {
  return numbers::interval_vec(end == End::end ? ring.normal : Vec3(-ring.normal));
}

double largest_angle(const numbers::Interval& y, const numbers::Interval& x) {
  using Mpfi = numbers::MpfiInterval<128>;
  return angle(Mpfi::between(y.lower, y.upper), Mpfi::between(x.lower, x.upper))
      .rounded_outward()
      .upper;
}

std::optional<Vec3> stored_end(const Spine& spine, End end) {
  struct Stored {
    bool last;
    std::optional<Vec3> operator()(const LineSpine& s) const { return last ? s.to : s.from; }
    std::optional<Vec3> operator()(const HermiteSpine& s) const { return last ? s.to : s.from; }
    std::optional<Vec3> operator()(const BezierSpine& s) const {
      return last ? s.points.back() : s.points.front();
    }
    std::optional<Vec3> operator()(const ArcSpine&) const { return std::nullopt; }
  };
  return std::visit(Stored{end == End::end}, spine);
}

double offset(const EndRing& end, const numbers::IntervalVec& center,
              const numbers::Interval& radius) {
  const numbers::Interval apart = numbers::norm(center - numbers::interval_vec(end.ring.center));
  return (apart + (radius - end.ring.radius).magnitude()).upper;
}

}  // namespace dupin::surfaces
