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

}  // namespace dupin::certification
