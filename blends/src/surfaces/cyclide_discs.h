#pragma once

#include <optional>
#include <vector>

#include "dupin/blends/cyclide_piece.h"
#include "surfaces/moving_disc.h"

namespace dupin::surfaces {

/// The discs of a piece of a cyclide: what is asked of many stretches is computed once.
class CyclideDiscs {
 public:
  explicit CyclideDiscs(const CyclidePiece& piece);

  /// Over the interval t within [0, 1]; none where the numbers do not tell that the disc moves.
  /// Of the outer skin, or of the parallel one at distance `wall` inside.
  [[nodiscard]] std::optional<MovingDisc> over(const numbers::Interval& t, double wall = 0) const;

 private:
  [[nodiscard]] numbers::Interval off_center(const numbers::Interval& t, const numbers::Interval& v,
                                             const numbers::Interval& v1) const;

  // Spheres (m; r) = p / w, less the first one, in Bernstein form; w^2 (m'; r') is a (tangent) +
  // b (last - first), where a and b are quadratic and a b' - a' b = k w.
  numbers::IntervalVec first_center_, tangent_, d_;
  numbers::Interval first_radius_, tangent_r_, dr_, k_;
  std::vector<numbers::Interval> weights_, radii_;
  std::vector<numbers::IntervalVec> centers_;
  std::vector<numbers::Interval> squared_pace_;  // <w^2 x', w^2 x'> for x = p / w
  std::optional<PeVector> arc_center_;           // less the first sphere, about
  std::vector<numbers::Interval> off_sphere_;    // <y, y> - c w^2 for y = p - o w about it
};

}  // namespace dupin::surfaces
