#include "dupin/blends/ringed_surface.h"

#include <cmath>
#include <numbers>
#include <variant>

#include <Eigen/Geometry>

#include "numbers/quadrature.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

// The mean over the ring at t of |x_t x x_u| / R. Closed forms, which are most of what pipes are
// made of; else by the trapezoid rule, which converges geometrically for periodic analytic
// functions.
double mean_stretch(const SpinePoint& point, const RadiusValue& radius) {
  constexpr int kAngles = 256;
  const double speed = point.first.norm();
  const double turning = point.first.cross(point.second).norm() / (speed * speed);
  if (turning == 0) {
    return std::hypot(speed, radius.first);
  }
  if (radius.first == 0 && radius.value * turning <= speed) {
    return speed;  // the cosine's mean is 0
  }
  double sum = 0;
  for (int i = 0; i < kAngles; ++i) {
    const double theta = 2 * kPi * i / kAngles;
    sum += std::hypot(speed - radius.value * turning * std::cos(theta), radius.first);
  }
  return sum / kAngles;
}

}  // namespace

SurfacePoint evaluate(const RingedSurface& surface, const FrameField& frames, double t, double u) {
  const SpinePoint y = evaluate(surface.spine, t);
  const RadiusValue radius = evaluate(surface.radius, t);
  const Frame frame = frames.at(t);
  const Vec3 e = std::cos(u) * frame.first + std::sin(u) * frame.second;
  const Vec3 e_u = std::cos(u) * frame.second - std::sin(u) * frame.first;
  const double speed = y.first.norm();
  // e is orthogonal to T, so e.T' = e.y'' / v.
  const double advance = speed - radius.value * e.dot(y.second) / speed;
  const Vec3 normal = (advance * e - radius.first * frame.tangent).normalized();
  return {y.position + radius.value * e, advance * frame.tangent + radius.first * e,
          radius.value * e_u, normal};
}

double area(const RingedSurface& surface) {
  const auto* const line = std::get_if<LineSpine>(&surface.spine);
  if (line != nullptr && is_linear(surface.radius)) {  // a cylinder or a cone
    const double start = evaluate(surface.radius, 0).value, end = evaluate(surface.radius, 1).value;
    return kPi * (start + end) * std::hypot((line->to - line->from).norm(), end - start);
  }
  return 2 * kPi * numbers::integral([&](double t) {
           const RadiusValue radius = evaluate(surface.radius, t);
           return radius.value * mean_stretch(evaluate(surface.spine, t), radius);
         });
}

double volume(const RingedSurface& surface) {
  return kPi * numbers::integral([&](double t) {
           const double radius = evaluate(surface.radius, t).value;
           return radius * radius * evaluate(surface.spine, t).first.norm();
         });
}

double length(const Spine& spine) {
  return numbers::integral([&](double t) { return evaluate(spine, t).first.norm(); });
}

}  // namespace dupin
