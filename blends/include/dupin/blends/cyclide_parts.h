#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "dupin/blends/cyclide_chain.h"
#include "dupin/blends/port_reference.h"
#include "dupin/kernel/vec.h"

namespace dupin {

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
/// its own three spheres, with parts of the common spheres between them, see kneecap.h.
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

}  // namespace dupin
