#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "dupin/blends/regularity.h"
#include "numbers/interval.h"
#include "surfaces/moving_disc.h"
#include "surfaces/swept_disc_tube.h"

namespace dupin::surfaces {

/// Encloses the discs of a stretch of a part. A ball counts as a disc of any normal.
struct DiscHull {
  std::vector<numbers::IntervalVec> centers;  ///< their convex hull contains all centres
  std::vector<numbers::IntervalVec>
      tangents;              ///< the cone they span contains all normals, but for `spread`
  Vec3 axis = Vec3::Zero();  ///< roughly the mean normal
  double cosine = 0;         ///< below those of all angles between axis and normals; 0: any normal
  numbers::Interval radius;  ///< of all radii; infinite where nothing is known
  double spread = 0;         ///< the largest angle between a normal and the cone

  [[nodiscard]] Vec3 middle() const;
  /// A length that falls as the stretch does.
  [[nodiscard]] double extent() const;
};

/// Encloses the largest value of x.w over the discs' points from above.
[[nodiscard]] double support(const DiscHull& hull, const Vec3& w);

/// Roughly the point of the hull furthest in this direction.
[[nodiscard]] Vec3 support_point(const DiscHull& hull, const Vec3& direction);

[[nodiscard]] inline double size(const ParameterInterval& t) { return t.to - t.from; }
[[nodiscard]] std::pair<ParameterInterval, ParameterInterval> halves(const ParameterInterval& t);

/// The discs of a piece, in outward rounded arithmetic; parameters are in [0, 1].
struct PieceDiscs {
  std::function<DiscHull(const ParameterInterval&)> hull;
  /// None where the numbers do not tell.
  std::function<std::optional<DiscPace>(const ParameterInterval&)> pace;
  /// Whether the discs at any two parameters of a stretch are disjoint because the spine turns by
  /// at most a right angle or is an arc, given that the piece is regular with this margin.
  std::function<bool(const ParameterInterval&, double margin)> turns_little;
  /// Whether all discs of a stretch are on one side of the planes of its first and of its last one.
  std::function<bool(const ParameterInterval&)> stays_on_one_side;
  bool full = true;  ///< the piece is the union of its discs
};

/// Of circles across a spine, or of the larger ones about ellipses, which are not full.
[[nodiscard]] PieceDiscs discs_of(const SweptDiscTube& tube, bool full);

/// How a disc moves over an interval; `steered` as for moving_disc().
using DiscMotion =
    std::function<std::optional<MovingDisc>(const numbers::Interval& t, bool steered)>;

/// Of any discs whose motion is known.
[[nodiscard]] PieceDiscs discs_of(const DiscMotion& motion);

}  // namespace dupin::surfaces
