#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "mesh/exact_mesh.h"

namespace dupin::rounding {

/// The triangles, by their places, at edges where the mesh touches itself and where rounding has
/// made one sheet pass through another, so that the triangles around do not bound inside and
/// outside in turn. `representatives` names for each
/// point the first of those that it touches.
[[nodiscard]] std::vector<std::uint32_t> crossed_contacts(
    const mesh::MeshView& mesh, std::span<const std::uint32_t> representatives);

/// Where a rounded mesh touches itself, as seen from where its coordinates were taken from: points
/// of it are in the same place at contacts only.
[[nodiscard]] std::vector<Contact> contacts_of(const TriMesh& mesh, const Vec3& origin);

}  // namespace dupin::rounding
