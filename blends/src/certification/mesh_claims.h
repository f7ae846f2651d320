#pragma once

#include <optional>

#include "dupin/blends/certificate.h"
#include "dupin/blends/tessellate.h"

namespace dupin::certification {

/// How the mesh that tessellate() makes of a part is claimed to keep to it. None where its rows are
/// not known, or too few. Throws as tessellate() does.
[[nodiscard]] std::optional<MeshClaim> mesh_claim(const Sphere& sphere,
                                                  const RingSampling& sampling, double tolerance);
[[nodiscard]] std::optional<MeshClaim> mesh_claim(const Chain& chain, const RingSampling& sampling,
                                                  double tolerance);

/// The largest angle about a ring's axis that a triangle spans, but for what rounding its corners
/// to the grid adds: claims count that by itself.
[[nodiscard]] double widest_turn(const TriMesh& mesh, const Ring& ring, double grid);

}  // namespace dupin::certification
