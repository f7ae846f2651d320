#pragma once

#include <array>
#include <optional>
#include <variant>

#include "dupin/blends/cyclic_blend.h"
#include "dupin/blends/port_reference.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// A cyclic blend [MS06] between two ports; see cyclic_blend.h. Between ellipses, or an ellipse and
/// a circle, an elliptic tube.
struct CyclicBlendBetween {
  PortReference from, to;
  CyclicBlendOptions options;
};

/// A tube between two ports on the spine that two cones have in common [BWL17]; see
/// two_cone_spine.h. The inner vertices lie on the ports' axes, `reach` off them.
struct TwoConeBlendBetween {
  PortReference from, to;
  std::array<double, 2> reach{1, 1};
  std::array<double, 3> m{1, 1, 1}, w{1, 1, 1};
};

/// What a ringed blend that ends in no port is tangent to there [BL15]: one of the surfaces that
/// rational_ringed_surface.h has a motion for.
struct CanalContact {
  double slope = 0;  ///< in the direction of travel
};
struct SphereContact {
  Vec3 center;
};
struct ObliqueConeContact {
  Vec3 apex;
};
struct ObliqueCylinderContact {
  Vec3 ruling;
};
/// The plane of the ring itself.
struct PlateContact {
  bool widening = false;  ///< in the direction of travel
};
using RingContact = std::variant<CanalContact, SphereContact, ObliqueConeContact,
                                 ObliqueCylinderContact, PlateContact>;

/// A ring that is no other part's, and what the blend is tangent to there.
struct FreeEnd {
  Vec3 center, direction;  ///< of travel, of any length but zero
  double radius = 1;
  RingContact contact;
};

using RingedBlendEnd = std::variant<PortReference, FreeEnd>;

/// A rational ringed blend [BL15]. Speeds are lengths of the end velocities; none: chosen.
struct RingedBlendBetween {
  RingedBlendEnd from, to;
  std::optional<double> k = {}, l = {};
  bool low_degree = false;  ///< (5, 2) instead of (9, 2), between canal surfaces only
};

}  // namespace dupin
