#include "canal/contact_feet.h"

#include <cmath>
#include <numbers>

#include "dupin/blends/pe_arc.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::canal {

double radius_lag(const MovingBall& ball) {
  const double lag = ball.radius_rate / ball.velocity.norm();
  if (!(std::abs(lag) < 1)) {
    throw Error(Errc::irregular_surface,
                "the ball's radius changes as fast as its centre moves, rate " +
                    decimal(lag, kMessageDigits) + ": it has no envelope there");
  }
  return lag;
}

Vec3 normal_at_foot(const Ring& quadric, const MovingBall& ball) {
  if (quadric.ellipse) {
    throw Error(Errc::invalid_argument, "a ball rolls on circular cylinders and cones only");
  }
  const PeVector sphere = contact_sphere(quadric), along = contact_tangent(quadric);
  const PeVector inside =
      sphere + product(PeVector{ball.center, -ball.radius} - sphere, along) * along;
  return (ball.center - inside.m).normalized();
}

std::array<Vec3, 2> contact_feet(const std::array<Ring, 2>& quadrics, const MovingBall& ball) {
  (void)radius_lag(ball);
  return {ball.center - ball.radius * normal_at_foot(quadrics[0], ball),
          ball.center - ball.radius * normal_at_foot(quadrics[1], ball)};
}

std::array<std::vector<Vec3>, 2> sampled_feet(const CanalFillet& loop, int samples) {
  std::array<std::vector<Vec3>, 2> feet;
  for (int i = 0; i < samples; ++i) {
    const auto [first, second] =
        contact_feet(loop.quadrics, ball(loop, 2 * std::numbers::pi * i / samples));
    feet[0].push_back(first);
    feet[1].push_back(second);
  }
  return feet;
}

}  // namespace dupin::canal
