#pragma once
#include <array>
#include "dupin/kernel/ring.h"
namespace dupin {
struct MovingBall {
  Vec3 center, velocity, acceleration;
  double radius = 1, radius_rate = 0, radius_acceleration = 0;
};
struct ContactArc {
  std::array<Vec3, 2> feet, normals;
  Vec3 center;
  double radius = 1;
  Vec3 to_first, across;
  double angle = 0;
};
[[nodiscard]] ContactArc contact_arc(const std::array<Ring, 2>& quadrics, const MovingBall& ball);
[[nodiscard]] Vec3 point(const ContactArc& arc, double angle);
[[nodiscard]] double least_regularity(const MovingBall& ball, const ContactArc& arc);
}  // namespace dupin
