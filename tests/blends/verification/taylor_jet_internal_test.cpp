#include <algorithm>

#include <gtest/gtest.h>

#include "support/fillet_loops.h"
#include "verification/rolling_balls.h"
#include "verification/taylor_jet.h"

namespace dupin::verification {
namespace {

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

}  // namespace
}  // namespace dupin::verification
