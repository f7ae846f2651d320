#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gmpxx.h>

#include "dupin/kernel/enclosure.h"
#include "dupin/kernel/ring.h"

namespace dupin {

/// What keeps two facing ends apart. The first of these that is not exactly zero decides, in this
/// order: axial distance (gap, overlap), radius (step), an ellipse's axes (turn), normals (kink),
/// lateral offset (offset).
enum class GapVerdict {
  welded,   ///< the same curve, bitwise: b's centre and radii are a's, its normal a's negated
  gap,      ///< axial distance > 0, be it one ulp
  overlap,  ///< axial distance < 0
  step,     ///< no axial distance, but different radii
  turn,     ///< ellipses with equal semi-axes, turned against each other
  kink,     ///< concentric within one plane of a, but b's normal is not a's negated; or (pair_ends)
            ///< ends that do not face each other, and belong together
  offset,   ///< nothing but a lateral offset
  open,     ///< the ends do not face each other (b.normal . a.normal >= 0), or there is no b
};

[[nodiscard]] std::string_view name(GapVerdict verdict);

/// One way in which two ends differ, by an exactly non-zero amount.
struct Deviation {
  enum class Kind {
    axial,   ///< length, signed
    radius,  ///< length, signed: b's minus a's
    across,  ///< length, signed, of the other semi-axis where one of the rings is an ellipse
    turn,    ///< angle between the axes of two ellipses
    kink,    ///< angle between b's normal and a's negated; 0 if they differ in length alone
    offset,  ///< length
    slope,   ///< change of dR/ds across the seam: an edge in the wall, not a gap
  };
  Kind kind = Kind::axial;
  Enclosure size;
  friend bool operator==(const Deviation&, const Deviation&) = default;
};

[[nodiscard]] std::string_view name(Deviation::Kind kind);

/// How two ends fit, computed from the stored coordinates without rounding.
///
/// A stored normal n is unit to rounding only, so lengths along it carry |n|: the rationals leave
/// it in, as stated with each, and the enclosures divide by it. Semi-axes of two ellipses are
/// compared with those that they are nearer to in direction. With d = b.center - a.center,
/// n = a.normal, m = b.normal:
struct GapReport {
  GapVerdict verdict = GapVerdict::open;
  mpq_class axial_dot;       ///< d . n: the axial distance times |n|; its sign is the verdict's
  mpq_class normal_squared;  ///< n . n
  mpq_class
      offset_squared;  ///< |d x n|^2 / n . n: the squared distance of b's centre from a's axis
  mpq_class distance_squared;         ///< d . d, between the centres
  mpq_class radius_difference;        ///< b.radius - a.radius
  mpq_class across_difference;        ///< the same for the semi-axes across
  mpq_class turn_sine_squared;        ///< of the angle between the axes of two ellipses, else 0
  mpq_class slope_difference;         ///< a.slope + b.slope; 0 where the walls continue each other
  mpq_class across_slope_difference;  ///< the same for the semi-axes across
  mpq_class kink_sine_squared;        ///< |n x m|^2 / (n . n m . m)
  mpq_class kink_cosine_squared;      ///< (n . m)^2 / (n . n m . m)

  Enclosure axial;   ///< d . n / |n|
  Enclosure offset;  ///< the root of offset_squared
  Enclosure radius;  ///< around radius_difference
  Enclosure across;  ///< around across_difference
  Enclosure turn;    ///< radians in [0, pi/4]
  Enclosure kink;    ///< radians in [0, pi], between m and -n

  std::vector<Deviation> deviations;  ///< all that are not zero, in order of Kind

  friend bool operator==(const GapReport&, const GapReport&) = default;
};

/// Measures from `a`, along its axis. Swapping the ends keeps everything but the sign of the radius
/// difference where the normals are opposite; a kinked pair has two axes to measure along.
/// Throws Error{invalid_argument} for an invalid ring.
[[nodiscard]] GapReport measure_gap(const Ring& a, const Ring& b);

/// A named end of a part.
struct Port {
  std::string name;
  Ring ring;
  std::string part;  ///< two ports of the same part are never paired; empty: of no part
};

/// Two ports that belong together, or one without a partner; positions in the span given.
struct GapPair {
  std::size_t first = 0;
  std::optional<std::size_t> second;  ///< > first
  GapReport report;                   ///< verdict `open` without a second
};

/// Whether the end at a position in a list of ports starts or ends in a part that is neither its
/// own nor that of the other end, as branches in their header and arms in a ball do.
using LiesInPart = std::function<bool(std::size_t port, std::size_t other)>;

/// Pairs the ports, each at most once: first those that are welded; then, nearest first, ports that
/// face each other with centres at most `connect` apart. Distances are compared exactly; ties go to
/// the lexicographically smaller names, then positions. Of what is left, ends that near that look
/// at least 60 degrees away from each other make pairs in the same way, with the verdict `kink`,
/// but for those that `lies_in_part` names. The rest stands alone, `open`. Ordered by `first`. O(n
/// log n) unless many ports have the same centre or most nearest ones contend for the same partner.
/// Throws Error{invalid_argument}, naming the port, for an invalid ring, and for a `connect` that
/// is negative or not finite.
[[nodiscard]] std::vector<GapPair> pair_ends(std::span<const Port> ports, double connect,
                                             const LiesInPart& lies_in_part = {});

}  // namespace dupin
