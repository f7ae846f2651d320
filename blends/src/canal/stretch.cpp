#include "canal/stretch.h"

#include "canal/rational_fillet.h"
#include "canal/rolling_ball.h"
#include "numbers/cosine_and_sine.h"

namespace dupin {
namespace canal {

using numbers::Interval;

Turn<Interval> turn(const ParameterInterval& at) {
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

BallJet<Interval> balls(const CanalFillet& fillet, const ParameterInterval& at) {
  const Turn<Interval> over = turn(at);
  return std::visit([&](const auto& motion) { return ball_jet<Interval>(motion, over); },
                    fillet.motion);
}

}  // namespace canal

double acceleration_bound(const CanalFillet& fillet, const ParameterInterval& at) {
  const auto jet = canal::balls(fillet, at);
  const numbers::Interval center = numbers::norm(
      {jet.center[0].acceleration, jet.center[1].acceleration, jet.center[2].acceleration});
  return (center + numbers::Interval(jet.radius.acceleration.magnitude())).upper;
}

}  // namespace dupin
