#pragma once

#include <optional>
#include <variant>

#include <Eigen/Geometry>

#include "dupin/blends/part_surface.h"
#include "shading/swept_patch.h"

namespace dupin::shading {

/// The disc, or any other face, in the plane of a ring.
struct FlatPatch {
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();
};

/// The rim of a wall: the strip along the normals of the surface that ends in a circle.
struct RimPatch {
  Ring ring;
};

/// A face of the smooth solid, or of a surface that this is cut out of.
using Patch = std::variant<SweptPatch, Sphere, FlatPatch, RimPatch>;

/// The foot of a place on the patch; none where it has no normal, as a ball at its centre.
[[nodiscard]] std::optional<Foot> foot_on(const Patch& patch, const Vec3& place);

/// Nearly the same, of a place nearly on it.
[[nodiscard]] std::optional<Foot> rough_foot_on(const Patch& patch, const Vec3& place);

/// Holds the patch; all of space for what is not a tube.
[[nodiscard]] Eigen::AlignedBox3d box_of(const Patch& patch);

}  // namespace dupin::shading
