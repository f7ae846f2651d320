#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "assembly/weld.h"
#include "dupin/blends/build.h"
#include "dupin/blends/resolve.h"
#include "dupin/kernel/ring.h"

namespace dupin::assembly {

/// The runs of an assembly as solids that are not yet united, and what their meshes are like.
struct RunSolids {
  std::vector<Solid> solids;      ///< in the order of the runs
  std::size_t runs = 0;           ///< sets of parts welded to each other along shared rings
  std::vector<PartReport> parts;  ///< by part: what is said of the mesh, nothing else
  /// Of fillets and hubs, whole, by their places in Assembly::parts.
  std::vector<std::pair<std::uint32_t, PartReport>> others;
};

/// Runs are tessellated, welded and proved to be solids; with those that fillets or hubs join them
/// to they make one. A run whose parts cross each other makes several. Throws as `build` does but
/// for `resolve` and `unite`. `given` has the sampling of each part, where these are those of a
/// larger assembly, and `within` rings in discs where that goes on.
[[nodiscard]] RunSolids solids_of_runs(const Assembly& assembly, const ResolvedAssembly& resolved,
                                       double grid, const BuildOptions& options,
                                       std::span<const RingSampling> given = {},
                                       std::span<const RingWithin> within = {});

/// How the rings of each part become polygons.
[[nodiscard]] std::vector<RingSampling> part_samplings(const Assembly& assembly,
                                                       const ResolvedAssembly& resolved,
                                                       double grid);

}  // namespace dupin::assembly
