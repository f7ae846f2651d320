#pragma once

#include <span>
#include <string>

#include "junction/hub_search.h"

namespace dupin::junction {

/// Why there is no hub, for people: `refused` is what was found with these ends and options. How
/// far ends would have to be further back is tried out (one part in 100 less does not do), and so
/// is a smoothness that would do.
[[nodiscard]] std::string advice(std::span<const Ring> ends, const JunctionOptions& options,
                                 const JunctionSearch& refused);

}  // namespace dupin::junction
