#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dupin/blends/part_surface.h"
#include "dupin/blends/pe_arc.h"
#include "dupin/kernel/ring.h"

namespace dupin {

/// What decides how a junction looks; what is not given is chosen.
struct JunctionOptions {
  /// Of the hub; none: the point nearest to the ends' axes, in the sense of least squares.
  std::optional<Vec3> center;
  std::optional<double> radius;  ///< of the hub; none: the least that is sound
  /// Angular radii of the caps, in radians, one for each end; none: as wide as the neighbours let
  /// them be, at most 75 degrees.
  std::vector<double> cap_angles = {};
  /// From 0, the most compact, to 1, the smoothest: the part of the straight pieces' lengths that
  /// the collars take over. At 1 they begin at the ends.
  double smoothness = 0;
};

/// What joins one end to the hub: a straight piece that goes on as the pipe or cone where there is
/// room for one, and the collar, a piece of a cyclide.
struct JunctionArm {
  Ring end;                       ///< its normal pointing into the junction
  std::optional<PeArc> straight;  ///< none: the collar begins at the end
  PeArc collar;                   ///< ends in the hub
};

/// Any number of ends joined into one smooth surface: a sphere less a cap for each end, and the
/// arms, tangent to the sphere along the caps' circles and to the pipes along the ends.
struct Junction {
  Sphere hub;
  std::vector<JunctionArm> arms;  ///< in the order of the ends
};

/// The circle of the hub in which the arm ends, its normal pointing into the hub.
[[nodiscard]] Ring cap_circle(const JunctionArm& arm);
/// The angular radius of that circle, seen from the hub's centre.
[[nodiscard]] double cap_angle(const JunctionArm& arm);
/// Of the straight piece, along the cone; 0 if there is none.
[[nodiscard]] double straight_length(const JunctionArm& arm);
/// The arm as a chain of one or two pieces from its end, flipped, to the cap's circle.
[[nodiscard]] Chain tube(const JunctionArm& arm);

/// How far a junction is from one that crosses itself.
struct JunctionMargins {
  double cap_gap = 0;  ///< least angle between two caps, in radians
  double power = 0;    ///< least power of a collar's start circle with respect to the hub, by the
                       ///< product of the radii of the hub and the cap's circle
};
[[nodiscard]] JunctionMargins margins(const Junction& junction);

/// "hub of radius 2.3 at (0, 0, 0), caps 12.1 degrees apart".
[[nodiscard]] std::string description(const Junction& junction);

/// Of the hub less its caps, and of all arms.
[[nodiscard]] double area(const Junction& junction);
/// Enclosed with the ends' discs.
[[nodiscard]] double volume(const Junction& junction);

/// Whether the surface neither folds nor crosses itself is decided by exact arithmetic on the
/// stored numbers (tangents taken to be PE-unit): collars are regular, caps disjoint, straight
/// pieces outside of the hub, and any two arms on different sides of a plane through its centre.
/// Empty if so, or what is wrong, or could not be proved.
[[nodiscard]] std::string unsoundness(const Junction& junction);

/// The junction of ends whose normals point out of their pipes and into it, and why there is none.
struct JunctionSearch {
  std::optional<Junction> junction;
  std::string reason;              ///< a sentence where there is none
  std::optional<std::size_t> end;  ///< the end at fault, if it is one
  /// Where the ends are too near to the hub: how far each would have to be moved back along its own
  /// cone, 0 for those that are not; then there would be a junction about the same centre.
  std::vector<double> setbacks = {};
};

/// Throws Error{invalid_argument} for fewer than two ends, ellipses, and options out of range.
[[nodiscard]] JunctionSearch search_junction(std::span<const Ring> ends,
                                             const JunctionOptions& options = {});

/// The same. Throws Error{infeasible_blend}, whose place is "end 3" for the third one, where there
/// is none.
[[nodiscard]] Junction junction_of(std::span<const Ring> ends, const JunctionOptions& options = {});

}  // namespace dupin
