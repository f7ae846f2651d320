#pragma once

#include <Eigen/Core>

namespace dupin {

/// A point or direction in the assembly frame; 24 bytes, no alignment demands, the same layout
/// under every -m flag.
using Vec3 = Eigen::Vector3d;

}  // namespace dupin
