#pragma once

#include <Eigen/Core>

namespace dupin {

/// A point or direction in the assembly frame; 24 bytes, no alignment demands, the same layout
/// under every -m flag.
using Vec3 = Eigen::Vector3d;

/// A place in a plane.
using Vec2 = Eigen::Vector2d;

}  // namespace dupin
