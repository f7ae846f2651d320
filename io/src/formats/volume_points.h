#pragma once

#include <vector>

#include "dupin/kernel/volume_mesh.h"

namespace dupin::formats {

/// All points as a format of doubles holds them, -0 as 0, those of the surface first. Throws
/// Error{invalid_argument} for a mesh that no file can hold, as text::writable_points does, and for
/// corners of tetrahedra out of range.
[[nodiscard]] std::vector<Vec3> writable_points(const VolumeMesh& mesh);

}  // namespace dupin::formats
