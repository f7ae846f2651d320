#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "dupin/kernel/mesh.h"

namespace dupin::boxes {

/// Unit rows, orthogonal to a few units in the last place, near the given first two directions.
[[nodiscard]] Eigen::Matrix3d orthonormal(const Eigen::Vector3d& first,
                                          const Eigen::Vector3d& second);

/// Orthonormal axes, but for rounding, as rows, in which at least one point spreads most, less and
/// least; those of coordinates where that is nothing finite. Looks at some points only: O(1).
[[nodiscard]] Eigen::Matrix3d principal_axes(std::span<const Vec3> points);

/// Orthonormal axes, but for rounding, as rows: the first along most of the vectors, by length and
/// either way round, the second along most of what these have across the first; none where no
/// vector has a length. O(n).
[[nodiscard]] std::optional<Eigen::Matrix3d> axes_along_most(std::vector<Vec3> vectors);

/// Orthonormal axes, but for rounding, as rows, along which boxes around the triangles have much
/// less surface than along the coordinate axes; none if such are not found. The first has most of
/// the long edges along it, the second most of what these have across the first. Looks at some
/// triangles only: O(1).
[[nodiscard]] std::optional<Eigen::Matrix3d> main_directions(std::span<const Vec3> points,
                                                             std::span<const Triangle> triangles);

}  // namespace dupin::boxes
