#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "canal/contact_feet.h"
#include "dupin/blends/canal_fillet.h"

namespace dupin {

ContactArc contact_arc(const std::array<Ring, 2>& quadrics, const MovingBall& ball) {
  const double lag = canal::radius_lag(ball);
  const Vec3 ahead = ball.velocity / ball.velocity.norm();
  ContactArc arc;
  arc.center = ball.center - ball.radius * lag * ahead;
  arc.radius = ball.radius * std::sqrt((1 - lag) * (1 + lag));
  std::array<Vec3, 2> to_feet;
  for (std::size_t i = 0; i < 2; ++i) {
    arc.normals[i] = canal::normal_at_foot(quadrics[i], ball);
    arc.feet[i] = ball.center - ball.radius * arc.normals[i];
    const Vec3 to_foot = lag * ahead - arc.normals[i];
    to_feet[i] = (to_foot - to_foot.dot(ahead) * ahead).normalized();
  }
  const Vec3 sum = to_feet[0] + to_feet[1], difference = to_feet[1] - to_feet[0];
  arc.to_first = to_feet[0];
  arc.across = ahead.cross(to_feet[0]);
  if (difference.dot(arc.across) < 0) {
    arc.across = -arc.across;
  }
  arc.angle = 2 * std::atan2(difference.norm(), sum.norm());
  arc.weight = sum.squaredNorm() / 4;
  arc.middle = arc.center + arc.radius / (2 * arc.weight) * sum;
  return arc;
}

Vec3 point(const ContactArc& arc, double angle) {
  return arc.center + arc.radius * (std::cos(angle) * arc.to_first + std::sin(angle) * arc.across);
}

double least_regularity(const MovingBall& ball, const ContactArc& arc) {
  // Along the circle it is constant + x cos + y sin.
  const Vec3& bend = ball.acceleration;
  const double speed_squared = ball.velocity.squaredNorm();
  const double constant = speed_squared - ball.radius_rate * ball.radius_rate -
                          ball.radius * ball.radius_acceleration -
                          bend.dot(arc.center - ball.center);
  const double x = -arc.radius * bend.dot(arc.to_first), y = -arc.radius * bend.dot(arc.across);
  double least = std::min(x, x * std::cos(arc.angle) + y * std::sin(arc.angle));
  const double valley = std::atan2(-y, -x);
  if (valley > 0 && valley < arc.angle) {
    least = -std::hypot(x, y);
  }
  return (constant + least) / speed_squared;
}

}  // namespace dupin
