#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "support/fillet_loops.h"
#include "verification/motions/rolling_balls.h"
#include "verification/motions/taylor_jet.h"

namespace dupin::verification {
namespace {

using test::holds;

// What holds at any place in a stretch is held, in less room than is needed without the formula.
TEST(TaylorJet, holds_what_is_in_a_stretch_in_less_room) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    const ParameterInterval t{1.25, 1.28125};
    const double middle = (t.from + t.to) / 2;
    const auto read = [&](const ParameterInterval& at) {
      return std::visit(BallReader<9>(*turn_stretch(at)), loop.motion);
    };
    const double reach =
        std::max(turn_stretch({t.from, middle})->length, turn_stretch({middle, t.to})->length);
    const auto all = read(t).center;
    const auto narrow = by_taylor<5>(read({middle, middle}).center, all, reach);
    double width = 0, width_without = 0;
    for (std::size_t k = 0; k < 5; ++k) {
      for (const double at : {t.from, 1.2578125, middle, t.to}) {
        const auto truth = read({at, at}).center;
        for (std::size_t i = 0; i < 3; ++i) {
          const Interval &x = narrow[i][k], &y = truth[i][k];
          EXPECT_LE(x.lower, y.upper) << name;
          EXPECT_GE(x.upper, y.lower) << name;
          width += x.upper - x.lower;
          width_without += all[i][k].upper - all[i][k].lower;
        }
      }
    }
    EXPECT_LE(width, width_without) << name;
    if (std::holds_alternative<RollingPartlyOnCones>(loop.motion)) {
      EXPECT_LT(width, width_without) << name;
    }
  }
}

// f'(x), f''(x), ... of a + b cos x + c sin x + d cos 2x + e sin 2x.
double derivative_at(const std::array<double, 5>& f, int order, double x) {
  const double turn = order * std::numbers::pi / 2, scale = std::pow(2, order);
  return (order == 0 ? f[0] : 0) + f[1] * std::cos(x + turn) + f[2] * std::sin(x + turn) +
         scale * (f[3] * std::cos(2 * x + turn) + f[4] * std::sin(2 * x + turn));
}

TEST(AngleWave, enclose_waves_and_their_derivatives) {
  const std::array<double, 5> f{0.5, -1.25, 2, 0.75, -3};
  const AngleWave wave{0.5, -1.25, 2, 0.75, -3};
  for (const ParameterInterval& t :
       {ParameterInterval{0, 1}, {0.25, 0.5}, {0.75, 0.8125}, {1.5, 1.5625}, {1.9, 1.9}}) {
    const auto jet = wave_jet<7>(wave, turn_stretch(t).value());
    for (const double at : {t.from, std::midpoint(t.from, t.to), std::nextafter(t.to, 0)}) {
      for (int k = 0; k < 7; ++k) {
        EXPECT_TRUE(holds(jet[std::size_t(k)], derivative_at(f, k, test::angle_at(at)), 1e-12))
            << at << " " << k;
      }
    }
    if (t.from == t.to) {
      EXPECT_LT(jet[0].upper - jet[0].lower, 1e-13);
      EXPECT_LT(jet[6].upper - jet[6].lower, 1e-11);
    }
  }
}

// Where a wave comes near to 0 and goes back, on stretches as long as it is away from there.
TEST(AngleWave, tell_the_sign_of_waves_that_all_but_touch_zero) {
  const double gap = 0x1p-30;
  for (const double place : {0.25, 0.3, 1.7}) {
    const double chi = test::angle_at(place);
    // 1 + gap - cos(x - chi)
    const AngleWave wave{1 + gap, -std::cos(chi), -std::sin(chi), 0, 0};
    for (double away = 0x1p-14; away < 0.125; away *= 2) {
      for (const ParameterInterval& t :
           {ParameterInterval{place + away, place + 2 * away}, {place - 2 * away, place - away}}) {
        EXPECT_GT(wave_jet<2>(wave, turn_stretch(t).value())[0].lower, 0) << place << " " << away;
      }
    }
    const ParameterInterval around{place - 0x1p-18, place + 0x1p-18};
    EXPECT_GT(wave_jet<2>(wave, turn_stretch(around).value())[0].lower, 0);
  }
}

}  // namespace
}  // namespace dupin::verification
