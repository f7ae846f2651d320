#pragma once

#include <optional>

#include "dupin/blends/cyclic_blend.h"

namespace dupin::ringed {

/// Speeds of a cyclic blend, tangent to both rings, whose spine is the cubic nearest to a circular
/// arc through the ends where both lie on one: d / cos^2(angle / 4) at the distance d. None if they
/// do not have this margin. A hundred times cheaper than the search for the least energy
/// (choose_velocities), and near it where ends face each other.
[[nodiscard]] std::optional<CyclicBlendOptions> arc_velocities(const Ring& from, const Ring& to,
                                                               double margin);

}  // namespace dupin::ringed
