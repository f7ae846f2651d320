#pragma once

#include "canal/centered_series.h"
#include "canal/moving_ball.h"
#include "canal/rational_fillet.h"
#include "canal/rolling_ball.h"
#include "dupin/blends/canal_fillet.h"
#include "numbers/interval.h"

namespace dupin::canal {

/// What motions are made of, on all of the interval, up to the double after it: there is no gap to
/// the next one that begins with this one's end. It holds at most one of the parameters pi/2 and
/// -pi/2 (with the period 2 pi), at an end.
[[nodiscard]] Turn<Jet<numbers::Interval>> turn(const ParameterInterval& at);

/// The balls there, with n - 1 derivatives. What turns at once in a corner is told of the side of
/// `stretch`.
template <std::size_t n>
[[nodiscard]] BallJet<CenteredSeries<n>> ball_series(const CanalFillet& fillet,
                                                     const ParameterInterval& at,
                                                     const ParameterInterval& stretch) {
  const double middle = (at.from + at.to) / 2;
  const auto here = turn({middle, middle}), over = turn(at);
  const auto beside = turn((stretch.from + stretch.to) / 2);
  const numbers::Interval offsets = numbers::Interval(at.from, numbers::next_above(at.to)) - middle;
  const auto series = [&](const auto& value, const auto& rate, double frequency) {
    return CenteredSeries<n>(wave<n>(value(here), rate(here), frequency),
                             wave<n>(value(over), rate(over), frequency), offsets);
  };
  const auto cosine = [](const auto& t) { return t.cosine.value; };
  const auto sine = [](const auto& t) { return t.sine.value; };
  const auto half_cosine = [](const auto& t) { return t.half_cosine.value; };
  const auto half_sine = [](const auto& t) { return t.half_sine.value; };
  const auto less = [](const auto& f) { return [&f](const auto& t) { return -f(t); }; };
  const Turn<CenteredSeries<n>> turning{series(cosine, less(sine), 1),
                                        series(sine, cosine, 1),
                                        series(half_cosine, less(half_sine), 0.5),
                                        series(half_sine, half_cosine, 0.5),
                                        beside.half_cosine_sign,
                                        beside.half_sine_sign};
  return std::visit(
      [&](const auto& motion) { return ball_jet<CenteredSeries<n>>(motion, turning); },
      fillet.motion);
}

/// The balls there, told by n - 1 derivatives.
template <std::size_t n>
[[nodiscard]] BallJet<Jet<numbers::Interval>> balls_by_series(const CanalFillet& fillet,
                                                              const ParameterInterval& at) {
  const auto series = ball_series<n>(fillet, at, at);
  const auto jet = [](const CenteredSeries<n>& s) {
    return Jet<numbers::Interval>(s.all.at[0], s.all.at[1], numbers::Interval(2) * s.all.at[2]);
  };
  return {{jet(series.center[0]), jet(series.center[1]), jet(series.center[2])},
          jet(series.radius)};
}

/// The balls there.
[[nodiscard]] BallJet<Jet<numbers::Interval>> balls(const CanalFillet& fillet,
                                                    const ParameterInterval& at);

}  // namespace dupin::canal
