#pragma once

#include <cstdint>

#include "dupin/blends/assembly.h"

namespace dupin::assembly {

/// How far the outer surface of a part lies outside of what the document describes: its wall where
/// radii are inside ones, half of it where they are in the middle, else 0.
[[nodiscard]] double outward_distance(const Assembly& assembly, const Part& part);

/// The shape with all radii of its own larger by `distance`; those that it has from ports, balls of
/// fillets and discs of flanges stay. Circles grow in their own planes, spheres about their
/// centres.
[[nodiscard]] PartShape outward_shape(const PartShape& shape, double distance);

/// The part's shape with the radii of its outer surface.
[[nodiscard]] PartShape outer_shape(const Assembly& assembly, std::uint32_t part);

}  // namespace dupin::assembly
