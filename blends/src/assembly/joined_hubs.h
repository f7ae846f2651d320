#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dupin/blends/resolve.h"
#include "dupin/blends/tessellation.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/ring.h"

namespace dupin::assembly {

/// By which part of the tolerance an arm's rings are sampled, so that the hub's triangles at its
/// cap may keep to it too.
constexpr double kArmShare = 0.7;

/// The hub of a junction as triangles, within the assembly's tolerance; `samplings` are those of
/// the runs of its arms. Throws Error{limit_exceeded} for more triangles than that.
[[nodiscard]] Tessellation hub_tessellation(const Assembly& assembly,
                                            const ResolvedJunction& junction,
                                            std::span<const RingSampling> samplings,
                                            std::size_t most_triangles);

/// A hub's mesh, of whose points so many first ones lie on its circles.
struct HubPatch {
  TriMesh mesh;
  std::size_t on_circles = 0;
};

/// A labelled mesh that is open along the circles of hubs, and these under their names: points on
/// the circles are the same.
[[nodiscard]] TriMesh joined_with_hubs(const TriMesh& runs, std::span<const HubPatch> hubs);

}  // namespace dupin::assembly
