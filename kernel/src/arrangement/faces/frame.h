#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

#include "arrangement/points/implicit_points.h"
#include "arrangement/triangle_intersection.h"

namespace dupin::arrangement {

/// Corners of a triangle with all these points inside, in the projection, and with its orientation.
/// Needs UpwardRounding.
[[nodiscard]] std::array<Eigen::Vector2d, 3> frame_around(const PointTable& points,
                                                          std::span<const PointId> ids,
                                                          const Projection& projection);

}  // namespace dupin::arrangement
