#pragma once

#include <span>
#include <vector>

#include "dupin/blends/resolve.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/ring.h"

namespace dupin::assembly {

/// The tubes of `parts` as one mesh, closed but for what fillets
/// trimmed: tubes that share a ring share its vertices, and every
/// other end gets a disc, but for ends that a fillet buries. `tubes` are the tessellations of all
/// parts, by part; `sampling` is the run's. Labels name the parts, and the discs of open ends as
/// ResolvedPart::end_names says.
[[nodiscard]] TriMesh welded(const ResolvedAssembly& assembly, std::span<const std::uint32_t> parts,
                             const std::vector<TriMesh>& tubes, const RingSampling& sampling);

/// The parts of a labelled mesh that share no points, each with the points it uses, in the order of
/// their first triangles.
[[nodiscard]] std::vector<TriMesh> connected_parts(const TriMesh& mesh);

}  // namespace dupin::assembly
