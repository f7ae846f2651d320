#pragma once

#include <vector>

#include "network/line_notes.h"
#include "network/port_pairs.h"

namespace dupin::network {

/// Gives ends without a radius that of the end they are joined to, else that of another end of
/// their component, and notes it. Those that no radius comes to keep none.
void infer_radii(const PipingLine& line, const std::vector<PortPair>& pairs,
                 std::vector<LinePort>& ports, LineNotes& notes);

}  // namespace dupin::network
