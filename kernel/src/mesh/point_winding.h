#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Geometry>

#include "exact/exact_numbers.h"
#include "mesh/exact_mesh.h"

namespace dupin::mesh {

[[nodiscard]] Eigen::AlignedBox3d bounds_of(const MeshView& mesh, std::uint32_t face);

/// A point whose coordinates are those of `scaled` divided by a whole number, and a box of doubles
/// that it lies in.
struct WindingPoint {
  exact::ExactVector scaled;
  int scale = 1;
  Eigen::AlignedBox3d around;
};

/// How often faces that bound closed surfaces of doubles wind about the point, exactly. Of one on
/// a face it says either what is in front of it or what is behind. O(faces).
[[nodiscard]] int winding_number(const MeshView& mesh, std::span<const std::uint32_t> faces,
                                 const WindingPoint& point);

/// Whether the face's plane, where the face's box is, has the point, exactly.
[[nodiscard]] bool may_touch(const MeshView& mesh, std::uint32_t face, const Vec3& point);

}  // namespace dupin::mesh
