#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>

#include "dupin/blends/canal_fillet.h"

namespace dupin::test {

constexpr double kPi = std::numbers::pi;

inline Vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}

/// A rigid motion.
struct Placement {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();

  [[nodiscard]] Vec3 operator()(const Vec3& p) const { return rotation * p + shift; }
  [[nodiscard]] Ring operator()(const Ring& ring) const {
    return {(*this)(ring.center), rotation * ring.normal, ring.radius, ring.slope};
  }
};

inline Placement random_placement(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Eigen::Quaterniond turn(normal(random), normal(random), normal(random), normal(random));
  return {turn.normalized().toRotationMatrix(), 5 * random_direction(random)};
}

/// How far a point is from a quadric, relative to its size there, and its outward normal.
inline double distance(const Ring& quadric, const Vec3& point) {
  const Vec3 to_point = point - quadric.center;
  const double along = to_point.dot(quadric.normal);
  const double radius = quadric.radius + quadric.slope * along;
  return ((to_point - along * quadric.normal).norm() - radius) / std::hypot(1, quadric.slope);
}

inline Vec3 normal(const Ring& quadric, const Vec3& point) {
  const Vec3 to_point = point - quadric.center;
  const Vec3 away = (to_point - to_point.dot(quadric.normal) * quadric.normal).normalized();
  return (away - quadric.slope * quadric.normal).normalized();
}

/// The worst residual of what defines a fillet at a parameter, by the size of the configuration:
/// the feet are on the quadrics, on the ball and on the circle, and the normals are common.
inline double residual(const CanalFillet& fillet, const MovingBall& ball) {
  const ContactArc arc = contact_arc(fillet.quadrics, ball);
  const double size = ball.radius + ball.center.norm() + fillet.quadrics[0].radius;
  double worst = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    worst = std::max(
        {worst, std::abs(distance(fillet.quadrics[i], arc.feet[i])) / size,
         std::abs((arc.feet[i] - ball.center).norm() - ball.radius) / size,
         (normal(fillet.quadrics[i], arc.feet[i]) - arc.normals[i]).norm() * ball.radius / size,
         (point(arc, i == 0 ? 0 : arc.angle) - arc.feet[i]).norm() / size});
  }
  return worst;
}

/// The worst of them at `samples` equally spaced parameters.
inline double residual(const CanalFillet& fillet, int samples = 64) {
  double worst = 0;
  for (int k = 0; k < samples; ++k) {
    worst = std::max(worst, residual(fillet, ball(fillet, 2 * kPi * k / samples)));
  }
  return worst;
}

/// The worst difference of the stated derivatives from those by central differences of order six,
/// relative to the largest derivative.
inline double derivative_error(const CanalFillet& fillet, double parameter, double step) {
  const auto difference = [&](const auto& of, int sign) {
    const auto at = [&](int k) { return of(ball(fillet, parameter + sign * k * step)); };
    return ((45.0 * (at(1) - at(-1)) - 9.0 * (at(2) - at(-2)) + 1.0 * (at(3) - at(-3))) /
            (60.0 * sign * step))
        .eval();
  };
  using Vec4 = Eigen::Vector4d;
  const auto value = [](const MovingBall& b) {
    return Vec4(b.center.x(), b.center.y(), b.center.z(), b.radius);
  };
  const auto rate = [](const MovingBall& b) {
    return Vec4(b.velocity.x(), b.velocity.y(), b.velocity.z(), b.radius_rate);
  };
  const auto acceleration = [](const MovingBall& b) {
    return Vec4(b.acceleration.x(), b.acceleration.y(), b.acceleration.z(), b.radius_acceleration);
  };
  const MovingBall here = ball(fillet, parameter);
  return std::max(
      (difference(value, 1) - rate(here)).norm() / (1 + rate(here).norm()),
      (difference(rate, 1) - acceleration(here)).norm() / (1 + acceleration(here).norm()));
}

}  // namespace dupin::test
