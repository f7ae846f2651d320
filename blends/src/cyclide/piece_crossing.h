#pragma once

#include <vector>

#include "dupin/blends/pe_arc.h"
#include "dupin/kernel/ring.h"

namespace dupin::cyclide {

/// Whether pieces cross each other, or one the part before `start` or after `end`, a diameter far
/// (normals in travel direction): by discs about half a radius apart, in doubles. A filter for
/// searches, no proof: what overlaps by less than a sixteenth of a radius, or is too long to be
/// looked at so closely, may pass.
[[nodiscard]] bool pieces_cross(const std::vector<PeArc>& pieces, const Ring& start,
                                const Ring& end);

}  // namespace dupin::cyclide
