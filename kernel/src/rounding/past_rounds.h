#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::rounding {

constexpr double kSnapReach = 16;  // steps, to begin with

/// What has been done before the solid is rounded anew: thickened, without some voids or slits, or
/// snapped.
struct PastRounds {
  std::size_t triangles = 0;  ///< of the solid as given
  double void_width = 0;      ///< of the widest filled void
  double slit_reach = 0;      ///< how far from the solid what was filled in open slits goes
  bool has_filled_slits = false, has_filled_voids = false;
  int thickenings = 0, snaps = 0;
  double moved = 0;              ///< by what was thickened or snapped
  std::size_t moved_points = 0;  ///< likewise
  std::size_t lost_shells = 0;   ///< of which snaps have left nothing
  Vec3 origin = Vec3::Zero();    ///< that it is given from already
  std::vector<Vec3> filled_places, snapped_places;
  std::size_t least_broken = std::numeric_limits<std::size_t>::max();  ///< before any snap
  int idle_snaps = 0;  ///< snaps of no fewer broken triangles than there had been before

  /// How far all that has taken any place.
  [[nodiscard]] double distance() const { return moved + filled(); }
  /// The part of it that filling has.
  [[nodiscard]] double filled() const { return std::max(void_width / 2, slit_reach); }

  /// A snap takes the place of further repair where this has the reach, in steps. What is cut where
  /// triangles cross may round to what it was: then edits reach farther each time before the next.
  [[nodiscard]] double snap_reach() const {
    return std::ldexp(kSnapReach, 2 * std::max(0, idle_snaps - 1));
  }
  /// Of a surface with so many broken triangles.
  void count_snap(std::size_t broken) {
    ++snaps;
    idle_snaps += broken < least_broken ? 0 : 1;
    least_broken = std::min(least_broken, broken);
  }
};

}  // namespace dupin::rounding
