#pragma once

#include <optional>
#include <vector>

#include "dupin/blends/elliptic_tube.h"
#include "dupin/blends/regularity.h"
#include "numbers/interval.h"
#include "surfaces/moving_disc.h"

namespace dupin::surfaces {

/// The discs across a spine: those of a ringed surface, or the larger ones about the ellipses of an
/// elliptic tube. Parameters are in [0, 1].
class SweptDiscTube {
 public:
  explicit SweptDiscTube(const RingedSurface& surface);
  explicit SweptDiscTube(const EllipticTube& tube);

  /// Control points and control vectors of a stretch: centres are in the convex hull of the former,
  /// tangents in the cone of the latter.
  struct Part {
    std::vector<numbers::IntervalVec> centers, tangents;
  };

  [[nodiscard]] Part curve(const ParameterInterval& t) const;
  [[nodiscard]] numbers::Interval radius(const ParameterInterval& t) const;

  /// Whether the discs at any two parameters in t are disjoint because the spine turns by at most a
  /// right angle, given that 1 - kappa R > margin >= 0; or because it is an arc of less than a turn
  /// whose radius is larger than theirs.
  [[nodiscard]] bool turns_little(const ParameterInterval& t, double margin) const;

  /// Whether all discs in t are on one side of the planes of its first and of its last one, because
  /// the spine is a line, or an arc of less than half a turn whose radius is larger than theirs.
  [[nodiscard]] bool stays_on_one_side(const ParameterInterval& t) const;

  /// None where the spine may stop.
  [[nodiscard]] std::optional<DiscPace> pace(const ParameterInterval& t) const;

 private:
  struct ArcRoom;
  [[nodiscard]] double turning(const ParameterInterval& t) const;
  [[nodiscard]] std::optional<ArcRoom> room_on_arc(const ParameterInterval& t) const;

  Spine spine_;
  std::vector<RadiusLaw> radii_;
};

}  // namespace dupin::surfaces
