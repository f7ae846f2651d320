#pragma once

#include <vector>

#include "network/piping_stretches.h"

namespace dupin::network {

/// Writes the parts of all chains, and of what is no chain (balls, plates), to the assembly, and
/// what was made of the joints to the network.
void add_parts(const PipingLine& line, const PipingOptions& options, const PipingSpans& spans,
               const std::vector<Chain>& chains, PipingNetwork& network, LineNotes& notes);

}  // namespace dupin::network
