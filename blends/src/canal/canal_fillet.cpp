#include "dupin/blends/canal_fillet.h"

#include <numbers>

#include "canal/rational_fillet.h"
#include "canal/rolling_ball.h"

namespace dupin {

MovingBall ball(const CanalFillet& fillet, double parameter) {
  const auto turn = canal::turn(parameter);
  const canal::BallJet<canal::Jet<double>> jet = std::visit(
      [&](const auto& motion) { return canal::ball_jet<canal::Jet<double>>(motion, turn); },
      fillet.motion);
  const auto& [x, y, z] = jet.center;
  return {Vec3(x.value, y.value, z.value),
          Vec3(x.rate, y.rate, z.rate),
          Vec3(x.acceleration, y.acceleration, z.acceleration),
          jet.radius.value,
          jet.radius.rate,
          jet.radius.acceleration};
}

std::vector<double> corners(const CanalFillet& fillet) {
  std::vector<double> result;
  if (const auto* through = std::get_if<RollingThrough>(&fillet.motion)) {
    if (through->above == 0) {
      result.push_back(-std::numbers::pi / 2);
    }
    if (through->below == 0) {
      result.push_back(std::numbers::pi / 2);
    }
  }
  return result;
}

}  // namespace dupin
