#pragma once

#include "dupin/kernel/mesh.h"

namespace dupin {

/// How often closed surfaces of finite coordinates wind about the point, exactly: 0 outside. Of a
/// point on a face it says either what is in front of it or what is behind. O(triangles).
[[nodiscard]] int winding_number(const TriMesh& mesh, const Vec3& point);

}  // namespace dupin
