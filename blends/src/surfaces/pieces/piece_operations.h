#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "dupin/blends/part_surface.h"
#include "dupin/blends/regularity.h"
#include "dupin/blends/tangency.h"
#include "surfaces/pieces/piece_discs.h"

namespace dupin::surfaces {

/// What decides about the lattice that mesh points lie on, beside the rings of ports.
struct PieceExtent {
  double smallest;     ///< length or radius
  double largest = 0;  ///< coordinate
  /// About: of a bend's inside from its axis, along it, or between its ends, which rows that are
  /// neighbours, or these ends, have between them.
  double clearance = std::numeric_limits<double>::infinity();
};

/// Certified bounds of the margin min(1 - R |n'| / (c'.n)), which is min(1 - kappa R) where the
/// discs are normal to the curve of their centres.
struct MarginBounds {
  double lower = 0;
  std::optional<double> upper;
  bool regular = false;  ///< proved, by these bounds or otherwise
};

/// Where a margin is proved, or fails.
struct ProvedStretches {
  Verdict verdict = Verdict::proved;
  std::vector<ParameterInterval> leaves;
  ParameterInterval where;
};

/// How the ring of a canal surface leaves it.
[[nodiscard]] MovingRing leaving_canal(const Ring& ring);

/// Nearly the largest margin, with room for a checker's own rounding, of ringed surfaces that are
/// regular together, and where a margin holds for them all.
[[nodiscard]] double nearly_largest_margin(const std::vector<RingedSurface>& tubes);
[[nodiscard]] ProvedStretches prove_margin(const std::vector<RingedSurface>& tubes, double margin);

/// A lower bound of a margin over a stretch; not positive if not known.
using MarginOver = std::function<double(const ParameterInterval&)>;

/// The same from bounds over stretches.
[[nodiscard]] double nearly_largest_margin(const MarginOver& bound);
[[nodiscard]] ProvedStretches prove_margin(const MarginOver& bound, double margin);

/// The margin of discs that move so.
[[nodiscard]] double margin_of(const std::optional<DiscPace>& pace);

/// The ring stored at an end, seen in the direction of travel.
struct EndRing {
  const Ring& ring;
  End end;

  [[nodiscard]] double parameter() const { return end == End::end ? 1 : 0; }
  [[nodiscard]] numbers::IntervalVec travel() const;
  [[nodiscard]] double slope() const { return end == End::end ? ring.slope : -ring.slope; }
};

/// An upper bound of atan2(y, x).
[[nodiscard]] double largest_angle(const numbers::Interval& y, const numbers::Interval& x);

/// Where a spine ends in a stored point, that one.
[[nodiscard]] std::optional<Vec3> stored_end(const Spine& spine, End end);

/// Of the ring's centre from `center`, and of its radius from `radius`.
[[nodiscard]] double offset(const EndRing& end, const numbers::IntervalVec& center,
                            const numbers::Interval& radius);

}  // namespace dupin::surfaces
