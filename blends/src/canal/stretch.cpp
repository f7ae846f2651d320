#include "canal/stretch.h"

#include <variant>

#include "numbers/cosine_and_sine.h"

namespace dupin {
namespace canal {

using numbers::Interval;

Turn<Jet<Interval>> turn(const ParameterInterval& at) {
  const Interval parameter(at.from, numbers::next_above(at.to));
  const auto [c, s] = numbers::cosine_and_sine(parameter);
  const auto [p, q] = numbers::cosine_and_sine_of_half_beyond_quarter(parameter);
  const Interval by_2 = 0.5, by_4 = 0.25;
  const auto middle = turn((at.from + at.to) / 2);
  return {Jet<Interval>(c, -s, -c),
          Jet<Interval>(s, c, -s),
          Jet<Interval>(p, -by_2 * q, -by_4 * p),
          Jet<Interval>(q, by_2 * p, -by_4 * q),
          middle.half_cosine_sign,
          middle.half_sine_sign};
}

BallJet<Jet<Interval>> balls(const CanalFillet& fillet, const ParameterInterval& at) {
  // Where generators meet a cone depends on the parameter in many ways at once, which intervals
  // take for independent.
  const bool on_cones = std::holds_alternative<RollingOnCones>(fillet.motion) ||
                        std::holds_alternative<RollingPartlyOnCones>(fillet.motion);
  if (!on_cones) {
    const auto over = turn(at);
    return std::visit([&](const auto& motion) { return ball_jet<Jet<Interval>>(motion, over); },
                      fillet.motion);
  }
  constexpr std::size_t kOrders = 7;
  return balls_by_series<kOrders>(fillet, at);
}

}  // namespace canal

double acceleration_bound(const CanalFillet& fillet, const ParameterInterval& at) {
  const auto jet = canal::balls(fillet, at);
  const numbers::Interval center = numbers::norm(
      {jet.center[0].acceleration, jet.center[1].acceleration, jet.center[2].acceleration});
  return (center + numbers::Interval(jet.radius.acceleration.magnitude())).upper;
}

}  // namespace dupin
