#pragma once

#include "dupin/blends/certificate.h"
#include "tube.h"

namespace dupin::verifier {

/// Whether the mesh that the claim describes stays within its error bound.
[[nodiscard]] bool mesh_follows(const Tube& tube, const MeshClaim& claim);
[[nodiscard]] bool mesh_follows(const Sphere& sphere, const MeshClaim& claim);

}  // namespace dupin::verifier
