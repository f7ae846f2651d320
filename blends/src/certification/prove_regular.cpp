#include "certification/prove_regular.h"

#include <algorithm>
#include <cmath>

#include "certification/swept_discs.h"

namespace dupin::certification {
namespace {

// Few digits, rounded down.
double shortened(double margin) {
  constexpr double kDigits = 0x1p20;
  return std::max(0.0, std::floor(margin * kDigits) / kDigits);
}

std::vector<RingedSurface> tubes_of(const CertifiedPiece& piece) {
  if (const auto* tube = std::get_if<RingedSurface>(&piece)) {
    return {*tube};
  }
  if (const auto* tube = std::get_if<EllipticTube>(&piece)) {
    return {{tube->start, tube->end, tube->spine, tube->first},
            {tube->start, tube->end, tube->spine, tube->second}};
  }
  return {};
}

// Every skin's lower bound of 1 - R |n'| / (c'.n) over the stretch; not positive if not known.
double margin_over(const CertifiedPiece& piece, double wall, const ParameterInterval& t) {
  const auto bound = [](const std::optional<DiscPace>& pace) {
    return pace && pace->advance > 0 && pace->radius.lower > 0
               ? (numbers::Interval(1) -
                  numbers::Interval(pace->radius.upper) * pace->turning / pace->advance)
                     .lower
               : -1;
  };
  const double outer = bound(pace_over(piece_discs(piece), t));
  const auto* cyclide = std::get_if<CyclidePiece>(&piece);
  if (cyclide == nullptr || wall == 0) {
    return outer;
  }
  const auto inner = moving_disc(*cyclide, {t.from, t.to}, wall);
  return std::min(outer, inner ? bound(pace(*inner, 0)) : -1);
}

// With room for a checker's own rounding; bounds of a piece that no polynomial gives exactly are
// wide, so that there is more room where stretches shall be long.
double nearly_largest(const CertifiedPiece& piece, double wall) {
  constexpr double kRoom = 0x1p-12, kShare = 1 - 0x1p-5;
  constexpr int kCells = 256;
  double least = 1;
  for (const RingedSurface& tube : tubes_of(piece)) {
    least = std::min(least, regularity(tube, {kRoom}).lower - kRoom);
  }
  if (!tubes_of(piece).empty()) {
    return shortened(least);
  }
  for (int i = 0; i < kCells; ++i) {
    least = std::min(least, margin_over(piece, wall, {double(i) / kCells, (i + 1.0) / kCells}));
  }
  return shortened(least * kShare);
}

struct Stretches {
  Verdict verdict = Verdict::proved;
  std::vector<ParameterInterval> leaves;
  ParameterInterval where;
};

// Both semi-axes of an elliptic tube are radii; its leaves are cut where either has a leaf's end.
Stretches proved_on(const std::vector<RingedSurface>& tubes, double margin) {
  Stretches result;
  std::vector<double> ends;
  for (const RingedSurface& tube : tubes) {
    const MarginProof proof = prove_margin(tube, margin);
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

Stretches proved_on(const CertifiedPiece& piece, double wall, double margin) {
  constexpr double kShortest = 0x1p-12;
  Stretches result;
  std::vector<ParameterInterval> stack{{0, 1}};
  while (!stack.empty()) {
    const ParameterInterval t = stack.back();
    stack.pop_back();
    if (margin_over(piece, wall, t) > margin) {
      result.leaves.push_back(t);
      continue;
    }
    if (t.to - t.from < kShortest) {
      return {Verdict::undecided, {}, t};
    }
    const double middle = (t.from + t.to) / 2;
    stack.push_back({middle, t.to});
    stack.push_back({t.from, middle});
  }
  return result;
}

}  // namespace

RegularClaim prove_regular(const PieceChain& chain, std::optional<double> margin) {
  RegularClaim claim{Verdict::proved, 1, {}, {}};
  for (const CertifiedPiece& piece : chain.pieces) {
    claim.margin = margin ? *margin : std::min(claim.margin, nearly_largest(piece, chain.wall));
  }
  for (std::size_t i = 0; i < chain.pieces.size(); ++i) {
    const auto seam = static_cast<double>(i);
    const auto tubes = tubes_of(chain.pieces[i]);
    const Stretches proof = tubes.empty() ? proved_on(chain.pieces[i], chain.wall, claim.margin)
                                          : proved_on(tubes, claim.margin);
    if (proof.verdict != Verdict::proved) {
      return {proof.verdict, claim.margin, {}, {seam + proof.where.from, seam + proof.where.to}};
    }
    for (const ParameterInterval& leaf : proof.leaves) {
      claim.leaves.push_back({seam + leaf.from, seam + leaf.to});
    }
  }
  return claim;
}

}  // namespace dupin::certification
