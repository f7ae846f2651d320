#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/exact_mesh.h"

namespace dupin::rounding {

/// The triangles, by their places, at edges where the mesh touches itself and where rounding has
/// made one sheet pass through another, so that the triangles around do not bound inside and
/// outside in turn. `representatives` names for each
/// point the first of those that it touches.
[[nodiscard]] std::vector<std::uint32_t> crossed_contacts(
    const mesh::MeshView& mesh, std::span<const std::uint32_t> representatives);

}  // namespace dupin::rounding
