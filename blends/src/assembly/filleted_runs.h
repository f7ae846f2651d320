#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "assembly/welded_runs.h"
#include "dupin/blends/resolve.h"
#include "dupin/kernel/mesh.h"
#include "surfaces/fillet_mesh.h"

namespace dupin::assembly {

/// Runs that fillets and junctions join into one solid, and these, as indices into the list of runs
/// and into ResolvedAssembly::fillets and ResolvedAssembly::junctions.
struct FilletedRuns {
  std::vector<std::size_t> runs, fillets, junctions = {};
};

/// Every run in exactly one group, in the order of their first runs.
[[nodiscard]] std::vector<FilletedRuns> filleted_runs(const ResolvedAssembly& assembly,
                                                      std::span<const WeldedRun> runs);

/// Parts that fillets and junctions join, as runs of one part each without the rest of theirs, and
/// the groups of these.
struct JoinedCores {
  std::vector<WeldedRun> parts;
  std::vector<FilletedRuns> groups;
};

/// Those of a group, in the order of their parts.
[[nodiscard]] JoinedCores joined_cores(const ResolvedAssembly& assembly, const FilletedRuns& group);

/// A fillet's loops as triangles, within the assembly's tolerance; the samplings are those of the
/// runs of its pipes. Throws Error{limit_exceeded} for more triangles than that.
[[nodiscard]] std::vector<surfaces::FilletMesh> fillet_meshes(
    const Assembly& assembly, const ResolvedFillet& fillet,
    const std::array<RingSampling, 2>& samplings, std::size_t most_triangles);

/// What fillets leave of a pipe's face: `meshes` are those of all fillets, by fillet.
[[nodiscard]] Tessellation trimmed(const ResolvedAssembly& assembly, std::uint32_t part,
                                   const RingSampling& sampling,
                                   const std::vector<std::vector<surfaces::FilletMesh>>& meshes);

/// Meshes that are open along the feet of these fillets, and the fillets between them, as one
/// closed mesh. Labels name what they did, and the fillets.
[[nodiscard]] TriMesh joined_by_fillets(
    const ResolvedAssembly& assembly, const std::vector<TriMesh>& runs,
    std::span<const std::size_t> fillets,
    const std::vector<std::vector<surfaces::FilletMesh>>& meshes);

}  // namespace dupin::assembly
