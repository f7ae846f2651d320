#include "origin.h"

#include <cmath>

namespace dupin::detail {
namespace {

struct Bounds {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
};

Bounds bounds(std::span<const Vec3> points) {
  Bounds all;
  if (!points.empty()) {
    all = {points[0], points[0]};
  }
  for (const Vec3& point : points) {
    all.low = all.low.cwiseMin(point);
    all.high = all.high.cwiseMax(point);
  }
  return all;
}

}  // namespace

double extent(std::span<const Vec3> points) {
  const Bounds all = bounds(points);
  return (all.high - all.low).maxCoeff();
}

Vec3 chosen_origin(const Origin& origin, std::span<const Vec3> points) {
  if (origin.choice == Origin::Choice::keep || points.empty()) {
    return Vec3::Zero();
  }
  if (origin.choice == Origin::Choice::given) {
    return origin.place;
  }
  const Bounds all = bounds(points);
  const double extent = (all.high / 2 - all.low / 2).maxCoeff();
  const double step = extent > 0 ? std::exp2(std::ilogb(extent) - 3) : 0;
  Vec3 place = all.low / 2 + all.high / 2;
  for (double& coordinate : place) {
    coordinate = step > 0 ? std::nearbyint(coordinate / step) * step : coordinate;
  }
  return place;
}

}  // namespace dupin::detail
