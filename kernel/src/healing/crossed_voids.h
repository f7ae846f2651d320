#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::healing {

/// Of a closed surface whose shells have been turned: the faces around voids that are what bodies
/// have in common that cross along edges. There four faces or more meet, no two in one half-plane,
/// and of two bodies one was inside out: each was taken for what the other does not have of it, and
/// one of them turned. With these faces turned, too, both are whole and face outward.
///
/// `was_turned`: per face, since the shells were found; `is_of_cavity`: such faces are around none.
[[nodiscard]] std::vector<std::uint32_t> faces_of_crossed_voids(
    std::span<const Vec3> points, std::span<const Triangle> triangles,
    std::span<const std::uint8_t> was_turned, std::span<const std::uint8_t> is_of_cavity);

}  // namespace dupin::healing
