#include "tessellation/unrolled_face.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "tessellation/plane_segments.h"
#include "tessellation/swept_mesh.h"

namespace dupin::tessellation {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

}  // namespace

UnrolledFace::UnrolledFace(const Ring& start, const Ring& end, const RingSampling& sampling)
    : origin_(start.center),
      axis_(end.normal),
      first_(first_direction(end, sampling)),
      second_(axis_.cross(first_)),
      height_((end.center - start.center).dot(axis_)),
      segments_(sampling.segments),
      radius_(start.radius),
      slope_((end.radius - start.radius) / height_) {}

Vec2 UnrolledFace::place(const Vec3& point) const {
  const Vec3 arm = point - origin_;
  const double share = arm.dot(axis_) / radius_;  // the integral of dh / (1 + slope h)
  const double along = slope_ == 0 ? share : std::log1p(slope_ * share) / slope_;
  const double unit = segments_ / kTurn;
  return {std::atan2(arm.dot(second_), arm.dot(first_)) * unit,
          std::hypot(1, slope_) * along * unit / kCompression};
}

double UnrolledFace::level(double y) const {
  const double along = y * kCompression * kTurn / (segments_ * std::hypot(1, slope_));
  return radius_ * (slope_ == 0 ? along : std::expm1(slope_ * along) / slope_) / height_;
}

Ring UnrolledFace::ring(double y) const {
  const double h = level(y) * height_;
  return {origin_ + h * axis_, axis_, radius_ + slope_ * h, slope_};
}

Vec3 UnrolledFace::point(const Vec2& place) const {
  const Ring at = ring(place.y());
  const double angle = place.x() / segments_ * kTurn;
  return at.center + at.radius * (std::cos(angle) * first_ + std::sin(angle) * second_);
}

double UnrolledFace::height(const Vec3& point) const {
  return (point - origin_).dot(axis_) / height_;
}

UnrolledCurve unrolled(std::vector<std::uint32_t> corners, const std::vector<Vec2>& place,
                       double around) {
  UnrolledCurve curve{std::move(corners), {}};
  for (const std::uint32_t corner : curve.corners) {
    Vec2 next = place[corner];
    if (!curve.places.empty()) {
      next.x() -= around * std::round((next.x() - curve.places.back().x()) / around);
    }
    curve.places.push_back(next);
  }
  const double gap = curve.places.front().x() - curve.places.back().x();
  curve.turns = -int(std::lround((gap - std::remainder(gap, around)) / around));
  if (curve.turns < 0) {
    std::reverse(curve.corners.begin() + 1, curve.corners.end());
    return unrolled(std::move(curve.corners), place, around);
  }
  const auto [lowest, highest] =
      std::ranges::minmax_element(curve.places, {}, [](const Vec2& p) { return p.y(); });
  curve.low = lowest->y();
  curve.high = highest->y();
  return curve;
}

double twice_area(const UnrolledCurve& curve) {
  double sum = 0;
  for (std::size_t i = 0; i < curve.places.size(); ++i) {
    sum += cross(curve.places[i] - curve.places[0],
                 curve.places[(i + 1) % curve.places.size()] - curve.places[0]);
  }
  return sum;
}

double area_below(const UnrolledCurve& curve, double around) {
  double sum = 0;
  Vec2 a = curve.places.back() - Vec2(around, 0);
  for (const Vec2& b : curve.places) {
    sum += (b.x() - a.x()) * (a.y() + b.y()) / 2;
    a = b;
  }
  return sum;
}

}  // namespace dupin::tessellation
