#pragma once

#include <iosfwd>

#include "dupin/io/report_json.h"

namespace dupin::cli {

/// How many ends are welded and open, and every pair that is neither.
void print_gaps(std::ostream& out, const GapSummary& summary);

/// Boundary loops, facing regions, and whether the union is one piece.
void print_mesh_gaps(std::ostream& out, const MeshGapSummary& summary);

}  // namespace dupin::cli
