#include "canal/stretch.h"

#include <cmath>

#include "canal/rational_fillet.h"
#include "canal/rolling_ball.h"
#include "numbers/mpfi_interval.h"

namespace dupin {
namespace canal {
namespace {

using numbers::Interval;
using Mpfi = numbers::MpfiInterval<64>;

Interval narrowed(const Mpfi& x) {
  const Enclosure e = x.rounded_outward();
  return {e.lower, e.upper};
}

}  // namespace

Turn<Interval> turn(double from, double to) {
  const Mpfi angle = Mpfi::between(from, to), half = (angle - Mpfi::pi() / Mpfi(2)) / Mpfi(2);
  const Interval c = narrowed(cosine(angle)), s = narrowed(sine(angle));
  const Interval p = narrowed(cosine(half)), q = narrowed(sine(half));
  const Turn<double> middle = turn(from + (to - from) / 2);
  return {{c, -s, -c},
          {s, c, -s},
          {p, -q / 2, -p / 4},
          {q, p / 2, -q / 4},
          middle.half_cosine_sign,
          middle.half_sine_sign};
}

BallJet<Interval> balls(const CanalFillet& fillet, double from, double to) {
  const Turn<Interval> over = turn(from, to);
  return std::visit([&](const auto& motion) { return ball_jet<Interval>(motion, over); },
                    fillet.motion);
}

}  // namespace canal

double acceleration_bound(const CanalFillet& fillet, double from, double to) {
  const auto jet = canal::balls(fillet, from, to);
  const numbers::Interval center = numbers::norm(
      {jet.center[0].acceleration, jet.center[1].acceleration, jet.center[2].acceleration});
  return (center + numbers::Interval(jet.radius.acceleration.magnitude())).upper;
}

}  // namespace dupin
