#pragma once

#include <optional>
#include <string>
#include <vector>

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
[[nodiscard]] Chain cyclide_blend(const Ring& from, const Ring& to);

/// What cyclide_blend finds, and why it is not simpler.
struct CyclideSearch {
  std::optional<Chain> tube;
  /// One sentence for each of the single, double and triple blend that was tried in vain: "single:
  /// ...". Pieces are also refused where they would cross each other or the parts at the ports, get
  /// thinner than an eighth of these, all but fold, or turn nearly all round.
  std::vector<std::string> rejected;
};

/// Throws Error{invalid_argument} for ellipses.
[[nodiscard]] CyclideSearch search_cyclide_blend(const Ring& from, const Ring& to);

}  // namespace dupin
