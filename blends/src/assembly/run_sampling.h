#pragma once

#include <cstddef>

#include "assembly/welded_runs.h"
#include "dupin/blends/assembly.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/ring.h"

namespace dupin::assembly {

/// How the rings of a run become polygons, `position` being the run's: one number of segments, the
/// document's or the most that any of its parts needs. Runs start at different angles, as aligned
/// facets of equal pipes that cross are the worst case for rounding.
[[nodiscard]] RingSampling run_sampling(const Assembly& assembly, const ResolvedAssembly& resolved,
                                        const WeldedRun& run, std::size_t position, double grid);

/// One part of the run as triangles, within the assembly's tolerance.
[[nodiscard]] Tessellation tessellated(const Assembly& assembly, const ResolvedPart& part,
                                       const RingSampling& sampling);

}  // namespace dupin::assembly
