#pragma once

#include <array>
#include <vector>

#include "dupin/blends/end.h"
#include "dupin/blends/ringed_surface.h"
#include "numbers/interval.h"
#include "verification/motions/bernstein.h"

namespace dupin::verification {

using numbers::Interval;
using numbers::IntervalVec;

/// The spine on a stretch: points / weight, and a curve with the direction of its velocity.
struct Stretch {
  Curve points;
  Polynomial weight;
  Curve tangent;
};

/// Discs on a stretch: their centres are in the hull of `centers`, their normals at most an angle
/// of `spread` outside of the cone of `tangents`. A ball has no tangents.
struct Discs {
  std::vector<IntervalVec> centers, tangents;
  Interval radius;
  double spread = 0;
};

/// A ringed surface, read exactly.
class Tube {
 public:
  explicit Tube(const RingedSurface& surface);

  [[nodiscard]] const ArcSpine* arc() const { return std::get_if<ArcSpine>(&surface_.spine); }
  /// A cylinder or cone.
  [[nodiscard]] bool is_cone() const;
  [[nodiscard]] const RingedSurface& surface() const { return surface_; }
  /// Of spines that are no arcs.
  [[nodiscard]] Stretch stretch(double from, double to) const;
  /// Coefficients of the radius; none for CyclideRadius.
  [[nodiscard]] Polynomial radius(double from, double to) const;
  [[nodiscard]] double radius_at(End end) const;
  [[nodiscard]] Interval radius_range(double from, double to) const;
  /// For 0 <= from <= to <= 1.
  [[nodiscard]] Discs discs(double from, double to) const;

 private:
  RingedSurface surface_;
  Curve points_;
  Polynomial weight_, radius_;
};

/// The largest value of x.w over the discs' points is below this.
[[nodiscard]] double furthest(const Discs& discs, const IntervalVec& w);

/// An upper bound, in radians, of how much the direction turns along the tangents.
[[nodiscard]] double turning(const std::vector<IntervalVec>& tangents);

}  // namespace dupin::verification
