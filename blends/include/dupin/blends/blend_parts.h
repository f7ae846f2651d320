#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dupin/blends/cyclic_blend.h"
#include "dupin/blends/cyclide_chain.h"
#include "dupin/blends/end.h"
#include "dupin/blends/junction.h"
#include "dupin/blends/spline_pipe.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// A port of another part, which is one of its ends, written "part.start" or "part.end".
struct PortReference {
  std::string part;
  End end = End::end;
  friend bool operator==(const PortReference&, const PortReference&) = default;
};

[[nodiscard]] std::string to_string(const PortReference& port);

/// Triangles in the way, and the file that they came from, as the document names it.
struct MeshObstacle {
  std::string file;
  std::shared_ptr<const TriMesh> mesh;
};

/// What a pipe keeps away from, how far at least: solids, other parts by their names, and meshes.
struct Avoidance {
  std::vector<std::variant<Obstacle, std::string, MeshObstacle>> obstacles;
  double clearance = 0;
};

/// A cyclic blend [MS06] between two ports; see cyclic_blend.h. Between ellipses, or an ellipse and
/// a circle, an elliptic tube. Where it would come too near to what it avoids, a spline pipe that
/// does not.
struct CyclicBlendBetween {
  PortReference from, to;
  CyclicBlendOptions options;
  std::optional<Avoidance> avoid = {};
};

/// A tube between two ports on the spine that two cones have in common [BWL17]; see
/// spine.h. The inner vertices lie on the ports' axes, `reach` off them.
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
  std::optional<Avoidance> avoid = {};
};

/// One to three cyclide pieces between two ports, see cyclide_blend.h; where there are none, a
/// ringed Hermite blend.
struct CyclideBlendBetween {
  PortReference from, to;
};

/// Where a chain's first piece leaves to, if not along a port: as the cone about `axis` with this
/// slope, the tangent of its half angle.
struct ChainDirection {
  Vec3 axis = Vec3::UnitZ();  ///< of travel, of any length but zero
  double slope = 0;
};

/// The first three spheres decide.
struct ChainFree {};

/// How the pieces of a chain meet: in one circle, tangent to each other; or each passing through
/// its own three spheres, with parts of the common spheres between them, see cyclide_tube.h.
enum class ChainJoints { smooth, kneecaps };

/// A chain of cyclide pieces [SD94], see cyclide_chain.h.
struct CyclideChainThrough {
  std::variant<ChainFree, ChainDirection, PortReference> from;
  /// Junctions and bias spheres in turn, from junction to junction; without the first junction
  /// where the chain begins at a port, whose cone has it.
  std::vector<PeVector> spheres;
  std::vector<PinnedTangent> tangents;  ///< by positions in `spheres`
  double wall = 0;                      ///< 0: solid
  ChainJoints joints = ChainJoints::smooth;
};

/// The fillet of a ball of this radius that rolls round the crossing of two pipes or cones, told by
/// their names; see fillet.h.
struct FilletBetween {
  std::array<std::string, 2> between;
  double radius = 1;
};

/// An end of a pipe or cone that is cut to fit another one, in which it lies.
struct CopeOfEnd {
  PortReference end;
  std::string to;
};

/// A disc without a bore of its own, its middle at a point.
struct FlangeAt {
  Vec3 center, normal;
  double radius = 1, thickness = 1;
};

/// The same about a port, its outer face level with the end; one that is solid lies before it.
struct FlangeOfEnd {
  PortReference at;
  double radius = 1, thickness = 1;
};

/// The same about a straight part, its middle `at` along its axis from its start.
struct FlangeOn {
  std::string run;
  double at = 0, radius = 1, thickness = 1;
};

/// Any number of ports joined by a hub; see junction.h.
struct JunctionOfPorts {
  std::vector<PortReference> ends;
  JunctionOptions options = {};
};

}  // namespace dupin
