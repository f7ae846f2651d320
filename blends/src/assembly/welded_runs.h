#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/resolve.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/ring.h"

namespace dupin::assembly {

/// Parts welded to each other along shared rings, in the order of a walk along them.
struct WeldedRun {
  std::vector<std::uint32_t> parts;
};

/// Every part in exactly one run; runs ordered by their first part in document order. A run that
/// is not a closed loop is walked from its end with the smaller first part.
[[nodiscard]] std::vector<WeldedRun> welded_runs(const ResolvedAssembly& assembly);

/// The spacing of the lattice that mesh points lie on: a power of two, at most 1/2048 of the
/// tolerance and of the smallest radius and straight length, and half of what a corner of any ring
/// stands out from its neighbours, where coordinates can be that fine. Throws
/// Error{invalid_argument} if the coordinates do not fit doubles on such a lattice.
[[nodiscard]] double lattice_spacing(const Assembly& assembly, const ResolvedAssembly& resolved);

/// How the rings of a run become polygons, `position` being the run's: one number of segments, the
/// document's or the most that any of its parts needs. Runs start at different angles, as aligned
/// facets of equal pipes that cross are the worst case for rounding.
[[nodiscard]] RingSampling run_sampling(const Assembly& assembly, const ResolvedAssembly& resolved,
                                        const WeldedRun& run, std::size_t position, double grid);

/// One part of the run as triangles, within the assembly's tolerance.
[[nodiscard]] Tessellation tessellated(const Assembly& assembly, const ResolvedPart& part,
                                       const RingSampling& sampling);

}  // namespace dupin::assembly
