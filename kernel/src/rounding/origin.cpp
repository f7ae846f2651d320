#include "rounding/origin.h"

#include <cmath>

#include <Eigen/Geometry>

namespace dupin::rounding {
namespace {

Eigen::AlignedBox3d bounds(std::span<const Vec3> points) {
  Eigen::AlignedBox3d all;
  for (const Vec3& point : points) {
    all.extend(point);
  }
  return all;
}

}  // namespace

double extent(std::span<const Vec3> points) {
  return points.empty() ? 0 : bounds(points).sizes().maxCoeff();
}

Vec3 chosen_origin(const Origin& origin, std::span<const Vec3> points) {
  if (origin.choice == Origin::Choice::keep || points.empty()) {
    return Vec3::Zero();
  }
  if (origin.choice == Origin::Choice::given) {
    return origin.place;
  }
  const Eigen::AlignedBox3d all = bounds(points);
  const double extent = (all.max() / 2 - all.min() / 2).maxCoeff();
  const double step = extent > 0 ? std::exp2(std::ilogb(extent) - 3) : 0;
  Vec3 place = all.min() / 2 + all.max() / 2;
  for (double& coordinate : place) {
    coordinate = step > 0 ? std::nearbyint(coordinate / step) * step : coordinate;
  }
  return place;
}

}  // namespace dupin::rounding
