#pragma once

#include <functional>
#include <span>
#include <string>

#include "junction/hub_search.h"

namespace dupin::junction {

/// What else is asked of a junction of ends, which may be further back than those that are given.
using JunctionNeed = std::function<bool(std::span<const Ring> ends, const Junction& junction)>;

/// Why there is no hub, for people: `refused` is what was found with these ends and options. How
/// far ends would have to be further back is tried out (one part in 100 less does not do), and so
/// is a smoothness that would do; of both that the junction's wall, if that is what is needed,
/// leaves it its bore.
[[nodiscard]] std::string advice(std::span<const Ring> ends, const JunctionOptions& options,
                                 const JunctionSearch& refused,
                                 const JunctionNeed& takes_wall = {});

/// dupin::junction_of() with that advice.
[[nodiscard]] Junction advised_junction(std::span<const Ring> ends, const JunctionOptions& options,
                                        const JunctionNeed& takes_wall);

}  // namespace dupin::junction
