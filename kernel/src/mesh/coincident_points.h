#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/vec.h"

namespace dupin::mesh {

struct ExactMesh;

/// One hash for points with the same coordinates (0.0 and -0.0 are the same).
[[nodiscard]] std::uint64_t hash_of(const Vec3& point);

/// For each point the index of the first one with the same coordinates (0.0 and -0.0 are the
/// same). The points are finite. O(n).
[[nodiscard]] std::vector<std::uint32_t> coincident_representatives(std::span<const Vec3> points);

/// For each point the first one that coincides with it exactly: another one only at contacts.
[[nodiscard]] std::vector<std::uint32_t> coincident_representatives(const ExactMesh& mesh);

/// Per point 1 if others are in the same place, as its representatives tell.
[[nodiscard]] std::vector<std::uint8_t> shared_places(
    std::span<const std::uint32_t> representatives);

/// The same as coincident_representatives() for a mesh whose contacts are known; quick if there are
/// none.
[[nodiscard]] std::vector<std::uint32_t> representatives_at_contacts(const ExactMesh& mesh);

}  // namespace dupin::mesh
