#pragma once

#include <array>
#include <cstdint>

namespace dupin {

/// Four indices into the points of a mesh; the last three are seen counter-clockwise from the side
/// away from the first, so that the volume is positive.
using Tetrahedron = std::array<std::uint32_t, 4>;

}  // namespace dupin
