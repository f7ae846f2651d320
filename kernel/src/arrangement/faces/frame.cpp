#include "arrangement/faces/frame.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace dupin::arrangement {

std::array<Eigen::Vector2d, 3> frame_around(const PointTable& points, std::span<const PointId> ids,
                                            const Projection& projection) {
  const int u = (projection.axis + 1) % 3, v = (projection.axis + 2) % 3;
  Eigen::AlignedBox2d box;
  double doubt = 0;  // how far a point may be off, in either coordinate
  for (const PointId id : ids) {
    const Vec3 p = points.approximation(id);
    box.extend(Eigen::Vector2d(p[u], p[v]));
    for (const int axis : {u, v}) {
      const Interval at = points.interval(id, axis);
      doubt = std::max({doubt, at.sup() - at.inf(), 0x1p-52 * std::abs(p[axis])});
    }
  }
  const Eigen::Vector2d center = box.center();
  // Of a face as small as that, all points may look like one.
  const double size = std::max(2 * box.diagonal().norm(), 16 * doubt);
  const double high = projection.orientation > 0 ? size : -size;
  return {center + Eigen::Vector2d(-2 * size, -high), center + Eigen::Vector2d(2 * size, -high),
          center + Eigen::Vector2d(0, 2 * high)};
}

}  // namespace dupin::arrangement
