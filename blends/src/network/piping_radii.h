#pragma once

#include <vector>

#include "network/line_notes.h"
#include "network/port_pairs.h"

namespace dupin::network {

/// Gives ends without a radius that of the end they are joined to, else that of another end of
/// their component, and notes it. Those that no radius comes to keep none.
void infer_radii(const PipingLine& line, const std::vector<PortPair>& pairs,
                 std::vector<LinePort>& ports, LineNotes& notes);

/// Where some components have walls, gives those without the wall of what they are joined to, be it
/// over others, and notes how many. `pairs` are of `ports`.
void infer_walls(const std::vector<PortPair>& pairs, const std::vector<LinePort>& ports,
                 PipingLine& line, LineNotes& notes);

}  // namespace dupin::network
