#pragma once

#include <optional>
#include <span>

#include <Eigen/Geometry>

#include "dupin/blends/part_surface.h"
#include "dupin/kernel/view.h"

namespace dupin::assembly {

/// A box about all that the surface bounds, in outward rounded arithmetic; infinite where nothing
/// is known of it. O(pieces). Along the axes of coordinates, or of a view, which need not be unit
/// vectors to the last bit: bounds are of the products with them.
[[nodiscard]] Eigen::AlignedBox3d part_box(const PartSurface& surface, const View& axes = {});

/// The axes along which boxes around the parts have much less surface than along those of
/// coordinates, as where long pipes lie askew; none if such are not found. O(pieces).
[[nodiscard]] std::optional<View> main_axes(std::span<const PartSurface* const> parts);

}  // namespace dupin::assembly
