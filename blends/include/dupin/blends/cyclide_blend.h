#pragma once

#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/ring.h"

namespace dupin {

/// The blend between two ports of neighbours (normals pointing out of these): a single piece where
/// the two cones have a common inscribed sphere at equal distances, else the double-cyclide blend
/// of least bending, else three pieces ([SD94] DCET, TCET); `kind` says which. The end rings are
/// the ports flipped, bitwise.
///
/// A single piece counts as meeting the end cone if its end tangent differs from the ring's by no
/// more than the rounding of the data. Throws Error{infeasible_blend} when three pieces do not do
/// either; a ringed blend may; Error{invalid_argument} for ellipses.
[[nodiscard]] CyclideTube cyclide_blend(const Ring& from, const Ring& to);

}  // namespace dupin
