#pragma once

#include <string_view>

#include "dupin/blends/cyclide_chain.h"
#include "dupin/kernel/ring.h"

namespace dupin {

/// A chain of one, two or three cyclide pieces from one port to another, G1 to the cylinders or
/// cones they end.
struct CyclideBlend {
  Ring start, end;  ///< the stored end rings, normals pointing out of the blend
  CyclideChain chain;
};

/// The blend between two ports of neighbours (normals pointing out of these): a single piece where
/// the two cones have a common inscribed sphere at equal distances, else the double-cyclide blend
/// of least bending, else three pieces ([SD94] DCET, TCET).
///
/// A single piece counts as meeting the end cone if its end tangent differs from the ring's by no
/// more than the rounding of the data. Throws Error{infeasible_blend} when three pieces do not do
/// either; a ringed blend may.
[[nodiscard]] CyclideBlend cyclide_blend(const Ring& from, const Ring& to);

/// "single", "double" or "triple".
[[nodiscard]] std::string_view kind(const CyclideBlend& blend);

}  // namespace dupin
