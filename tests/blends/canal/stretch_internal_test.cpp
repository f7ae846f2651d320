#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "canal/stretch.h"

namespace dupin::canal {
namespace {

using numbers::Interval;

bool holds(const Interval& interval, double x) {
  return interval.lower <= x && x <= interval.upper;
}

std::vector<CanalFillet> samples() {
  const Ring thick{{0, 0, 0}, {1, 0, 0}, 2}, thin{{0, 0, 0.1}, {0.6, 0.8, 0}, 1};
  const Ring beside{{0, 0, 0.9}, {0, 1, 0}, 1.5}, cone{{0, 0, 3}, {0, 0, 1}, 1, -0.3};
  return {rolling_ball_fillets({thick, thin}, 0.4)[1],
          rolling_ball_fillets({thick, beside}, 0.4)[0],
          rolling_ball_fillets({thick, cone}, 0.4)[0], rational_fillets({thick, thin}, 0.4)[0]};
}

// What is computed at a parameter lies, up to rounding, in what is enclosed around it; enclosures
// shrink with their stretches.
TEST(Stretch, encloses_the_balls_and_their_motion) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> parameter(-std::numbers::pi, std::numbers::pi);
  for (const CanalFillet& fillet : samples()) {
    for (int i = 0; i < 100; ++i) {
      const double t = parameter(random);
      const MovingBall at = ball(fillet, t);
      for (const double half : {1e-2, 1e-4}) {
        const auto jet = balls(fillet, {t - half, t + half});
        for (int k = 0; k < 3; ++k) {
          const auto& c = jet.center[std::size_t(k)];
          EXPECT_TRUE(holds(c.value + Interval(-1e-14, 1e-14), at.center[k]));
          EXPECT_TRUE(holds(c.rate + Interval(-1e-12, 1e-12), at.velocity[k]));
          EXPECT_TRUE(holds(c.acceleration + Interval(-1e-10, 1e-10), at.acceleration[k]));
        }
        EXPECT_TRUE(holds(jet.radius.value + Interval(-1e-14, 1e-14), at.radius));
        const double least = at.acceleration.norm() + std::abs(at.radius_acceleration);
        const double bound = acceleration_bound(fillet, {t - half, t + half});
        EXPECT_GE(bound * (1 + 1e-10), least);
        EXPECT_LE(bound, least * (1 + 1000 * half) + 2000 * half);
      }
    }
  }
}

}  // namespace
}  // namespace dupin::canal
