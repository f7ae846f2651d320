#pragma once

#include <cstddef>

#include "dupin/blends/certificate.h"
#include "dupin/kernel/mesh.h"
#include "verification/solid.h"

namespace dupin::certification {

/// Proves that an arm has nothing in common with its hub but the cap, by stretches that are halved
/// until each shows it, at most so many.
[[nodiscard]] ClearanceClaim prove_at_hub(const verification::Solid& arm, const Sphere& hub,
                                          std::size_t boxes);

/// What may be claimed of a hub's mesh whose caps' polygons have at least so many sides: the
/// fewest segments that its triangles' circles ask for. The bound is left to the checker.
[[nodiscard]] MeshClaim hub_mesh_claim(const Sphere& hub, const TriMesh& mesh,
                                       std::uint32_t fewest_sides, double grid);

}  // namespace dupin::certification
