#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "verification/motions/jet.h"

namespace dupin::verification {

/// An enclosure over a stretch, by Taylor's formula, of the derivative of an order: `middle` are
/// the derivatives at a parameter in it, `all` those on all of it, of which the last is taken, and
/// `reach` is how far the parameter gets from there.
template <std::size_t count>
[[nodiscard]] Interval taylor_sum(const Jet<count>& middle, const Jet<count>& all, double reach,
                                  std::size_t order) {
  const Interval h(-reach, reach);
  Interval sum = 0, power = 1;  // h^i / i!
  for (std::size_t i = 0; order + i < count; ++i) {
    sum = sum + power * (order + i + 1 < count ? middle : all)[order + i];
    power = power * h / Interval(double(i + 1));
  }
  return sum;
}

/// Enclosures of derivatives by Taylor's formula, as far as they are better.
template <std::size_t count, std::size_t more>
[[nodiscard]] Jet<count> by_taylor(const Jet<more>& middle, const Jet<more>& all, double reach) {
  static_assert(count < more);
  Jet<count> result;
  for (std::size_t k = 0; k < count; ++k) {
    result[k] = intersection(taylor_sum(middle, all, reach, k), all[k]);
  }
  return result;
}

template <std::size_t count, std::size_t more>
[[nodiscard]] JetVec<count> by_taylor(const JetVec<more>& middle, const JetVec<more>& all,
                                      double reach) {
  return {by_taylor<count>(middle[0], all[0], reach), by_taylor<count>(middle[1], all[1], reach),
          by_taylor<count>(middle[2], all[2], reach)};
}

/// A stretch of an angle chi.
struct AngleStretch {
  Interval cosine, sine;
  Interval middle_cosine, middle_sine;  ///< at one angle in it
  double reach = 0;                     ///< at most how far chi is from that one
};

/// f(chi) = c0 + c1 cos chi + c2 sin chi + c3 cos 2 chi + c4 sin 2 chi.
using AngleWave = std::array<Interval, 5>;

/// The derivative of an order, at angles of which the double's cosine and sine are known, too.
[[nodiscard]] inline Interval derivative_of(const AngleWave& wave, std::size_t order,
                                            const std::array<Interval, 4>& at) {
  const auto turned = [order](const Interval& cosine, const Interval& sine) {
    const Interval value = order % 2 == 0 ? cosine : sine;
    return order % 4 < 2 ? value : -value;
  };
  const auto& [cosine, sine, double_cosine, double_sine] = at;
  const Interval single = wave[1] * turned(cosine, -sine) + wave[2] * turned(sine, cosine);
  const Interval twice =
      wave[3] * turned(double_cosine, -double_sine) + wave[4] * turned(double_sine, double_cosine);
  const Interval rest = single + Interval(double(1ULL << order)) * twice;
  return order == 0 ? wave[0] + rest : rest;
}

/// Over a stretch, by Taylor's formula about its middle: where the wave all but touches 0, as where
/// one cone all but touches another, intervals of its terms would tell its sign on the shortest
/// stretches only.
template <std::size_t count>
[[nodiscard]] Jet<count> wave_jet(const AngleWave& wave, const AngleStretch& turn) {
  constexpr std::size_t kTerms = 4;
  const auto places = [](const Interval& cosine, const Interval& sine) {
    return std::array{cosine, sine, square(cosine) - square(sine), Interval(2) * cosine * sine};
  };
  const auto all = places(turn.cosine, turn.sine);
  const auto middle = places(turn.middle_cosine, turn.middle_sine);
  const Interval h(-turn.reach, turn.reach), h2 = square(h);
  std::array<Interval, count + kTerms - 1> at;
  for (std::size_t k = 0; k < at.size(); ++k) {
    at[k] = derivative_of(wave, k, middle);
  }
  Jet<count> result;
  for (std::size_t k = 0; k < count; ++k) {
    const Interval rest = square(h2) / 24 * derivative_of(wave, k + kTerms, all);
    result[k] =
        intersection(at[k] + h2 / 2 * at[k + 2] + h * (at[k + 1] + h2 / 6 * at[k + 3]) + rest,
                     derivative_of(wave, k, all));
  }
  return result;
}

}  // namespace dupin::verification
