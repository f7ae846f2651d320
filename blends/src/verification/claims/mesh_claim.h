#pragma once

#include <array>
#include <optional>

#include "dupin/blends/certificate.h"
#include "verification/solid.h"

namespace dupin::verification {

/// How t is measured on a band: as it is, or by the length of the way where that varies less.
enum class Measure { length, parameter };

/// Upper bounds, over a stretch, of |x_tt|, |x_tu|, |x_uu| in a frame that does not spin, of |n'|,
/// and of how long it is, as t is measured.
struct BandBounds {
  double along = 0, mixed = 0, around = 0, turning = 0, length = 0;
};

/// By so many cells, and by both measures: to enclose the discs is what takes time. None where
/// nothing is known of them.
[[nodiscard]] std::optional<std::array<BandBounds, 2>> bounds_over(const Motion& motion,
                                                                   double from, double to,
                                                                   int cells);

/// How large radii and the coordinates of centres may be; infinite where nothing is known of them.
[[nodiscard]] double size_of(const Solid& solid);

/// Whether it says what only chains of several skins or with kneecaps have.
[[nodiscard]] bool is_of_chain(const MeshClaim& claim);

/// What snapping to the grid and the rounding of coordinates of this size may add.
[[nodiscard]] Interval displacement(double grid, double size);

/// Whether the claim follows from the part's numbers.
[[nodiscard]] bool follows(const Solid& solid, const MeshClaim& claim);

}  // namespace dupin::verification
