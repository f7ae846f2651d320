#include "arrangement/operand_slabs.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

namespace dupin::arrangement {
namespace {

Vec3 middle(const IntervalPoint& point) {
  return Vec3(point[0].inf(), point[1].inf(), point[2].inf()) / 2 +
         Vec3(point[0].sup(), point[1].sup(), point[2].sup()) / 2;
}

// Any vectors would be right: ranges are of products with just these.
std::array<Vec3, 3> directions_of(const ArrangementInput& input, std::size_t operand) {
  Vec3 longest = Vec3::UnitX(), beside = Vec3::UnitY();
  double most = 0;
  for (std::uint32_t t = input.first_triangle[operand]; t < input.first_triangle[operand + 1];
       ++t) {
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = middle(input.points.interval(input.triangles[t][k]));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 edge = corners[(k + 1) % 3] - corners[k];
      if (const double length = edge.stableNorm(); length > most) {
        most = length;
        longest = edge / length;
        beside = corners[(k + 2) % 3] - corners[k];
      }
    }
  }
  const Vec3 across = longest.cross(beside.stableNormalized()).stableNormalized();
  return {longest, across, longest.cross(across)};
}

Interval along(const IntervalPoint& point, const Vec3& direction) {
  return point[0] * direction[0] + point[1] * direction[1] + point[2] * direction[2];
}

}  // namespace

OperandSlabs::OperandSlabs(const ArrangementInput& input, std::size_t operand)
    : directions_(directions_of(input, operand)) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ranges_.fill({kInfinity, -kInfinity});
  for (std::uint32_t t = input.first_triangle[operand]; t < input.first_triangle[operand + 1];
       ++t) {
    for (const PointId corner : input.triangles[t]) {
      const IntervalPoint point = input.points.interval(corner);
      for (std::size_t k = 0; k < 3; ++k) {
        const Interval here = along(point, directions_[k]);
        ranges_[k].first = std::min(ranges_[k].first, here.inf());
        ranges_[k].second = std::max(ranges_[k].second, here.sup());
      }
    }
  }
}

bool OperandSlabs::may_contain(const IntervalPoint& point) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const Interval here = along(point, directions_[k]);
    if (here.sup() < ranges_[k].first || here.inf() > ranges_[k].second) {
      return false;
    }
  }
  return true;
}

}  // namespace dupin::arrangement
