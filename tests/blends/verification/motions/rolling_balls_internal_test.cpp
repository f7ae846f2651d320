#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "support/fillet_loops.h"
#include "verification/motions/rolling_balls.h"

namespace dupin::verification {
namespace {

using test::holds;

TEST(TurnStretch, holds_the_functions_of_its_angles) {
  for (const ParameterInterval& t :
       {ParameterInterval{0, 1}, {0.125, 0.25}, {0.5, 0.75}, {1, 1.25}, {1.5, 2}, {0.3, 0.3}}) {
    const auto turn = turn_stretch(t);
    ASSERT_TRUE(turn);
    for (const double at : {t.from, (t.from + t.to) / 2, t.to}) {
      // At 1 the half that ends there is meant.
      const double chi = at == 1 && t.to == 1 ? std::numbers::pi / 2 : test::angle_at(at);
      const double psi = chi / 2 + std::numbers::pi / 4;
      EXPECT_TRUE(holds(turn->cosine, std::cos(chi), 1e-15)) << at;
      EXPECT_TRUE(holds(turn->sine, std::sin(chi), 1e-15)) << at;
      EXPECT_TRUE(holds(turn->half_cosine, std::cos(psi), 1e-15)) << at;
      EXPECT_TRUE(holds(turn->half_sine, std::sin(psi), 1e-15)) << at;
    }
    const double grows =
        test::angle_at(t.to == 1 ? std::nextafter(1, 0) : t.to) - test::angle_at(t.from);
    EXPECT_GE(turn->length, grows - 1e-15);
    EXPECT_LE(turn->length, 4.0001 * (t.to - t.from) + 1e-300);
  }
}

TEST(TurnStretch, is_none_beyond_a_half) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const ParameterInterval& t : {ParameterInterval{0.5, 1.5},
                                     {-0.5, 0.5},
                                     {1.5, 2.5},
                                     {2, 2.5},
                                     {3, 3},
                                     {0.5, 0.25},
                                     {kNaN, 1},
                                     {0, kNaN}}) {
    EXPECT_FALSE(turn_stretch(t)) << t.from << " " << t.to;
  }
}

TEST(TurnStretch, reaches_as_far_from_its_middle_as_the_longer_half) {
  for (const ParameterInterval& t : {ParameterInterval{0, .5}, {.5, .9375}, {1, 1.5}, {1.5, 2}}) {
    const auto turn = turn_stretch(t);
    ASSERT_TRUE(turn);
    const double middle = test::angle_at((t.from + t.to) / 2);
    const double end = t.to == 2 ? 3 * std::numbers::pi / 2 : test::angle_at(t.to);
    const double most = std::max(middle - test::angle_at(t.from), end - middle);
    EXPECT_GE(turn->reach, most - 1e-15);
    EXPECT_LE(turn->reach, 1.25 * most);
    EXPECT_TRUE(holds(turn->middle_cosine, std::cos(middle), 1e-15));
    EXPECT_TRUE(holds(turn->middle_sine, std::sin(middle), 1e-15));
    EXPECT_LT(turn->middle_sine.upper - turn->middle_sine.lower, 1e-14);
    EXPECT_LT(turn->middle_cosine.upper - turn->middle_cosine.lower, 1e-14);
  }
}

// What the evaluator says, whose formulas are written by another hand, is in the enclosures, and
// these are narrow at one place; the third derivative is what the second one's difference says.
TEST(BallReader, holds_the_balls_of_all_motions) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    for (const ParameterInterval& t : {ParameterInterval{0.125, 0.1875},
                                       {0.5, 0.5},
                                       {0.75, 0.8125},
                                       {1.25, 1.3125},
                                       {1.9, 1.9}}) {
      const auto balls = std::visit(BallReader<4>(*turn_stretch(t)), loop.motion);
      for (const double at : {t.from, (t.from + t.to) / 2, t.to}) {
        const double chi = test::angle_at(at), h = 1e-5;
        const MovingBall truth = ball(loop, chi);
        EXPECT_TRUE(holds(part(balls.center, 0), truth.center, 1e-13)) << name << " " << at;
        EXPECT_TRUE(holds(part(balls.center, 1), truth.velocity, 1e-12)) << name << " " << at;
        EXPECT_TRUE(holds(part(balls.center, 2), truth.acceleration, 1e-11)) << name << " " << at;
        EXPECT_TRUE(holds(balls.radius[0], truth.radius, 1e-13)) << name << " " << at;
        EXPECT_TRUE(holds(balls.radius[1], truth.radius_rate, 1e-12)) << name << " " << at;
        EXPECT_TRUE(holds(balls.radius[2], truth.radius_acceleration, 1e-11)) << name << " " << at;
        const Vec3 third =
            (ball(loop, chi + h).acceleration - ball(loop, chi - h).acceleration) / (2 * h);
        EXPECT_TRUE(holds(part(balls.center, 3), third, 1e-4)) << name << " " << at;
      }
      if (t.from == t.to) {
        for (std::size_t k = 0; k < 3; ++k) {
          for (const Interval& x : part(balls.center, k)) {
            EXPECT_LT(x.upper - x.lower, 1e-11) << name;
          }
        }
      }
    }
  }
}

double product(const Ring& ring, const Vec3& a, double a_weight, const Vec3& b, double b_weight) {
  const double an = a.dot(ring.normal), bn = b.dot(ring.normal);
  return a.dot(b) - an * bn -
         (ring.radius * a_weight + ring.slope * an) * (ring.radius * b_weight + ring.slope * bn);
}

TEST(Discriminant, is_that_of_where_generators_meet_the_other_cone) {
  const RollingOnCones motion{{{1, 2, 3}, Vec3(1, 0.25, -0.5).normalized(), 4, 0.125},
                              {{2, 2.5, 4}, Vec3(0.5, 1, 2).normalized(), 1.5, -0.25},
                              Vec3(2, -1, 0).normalized(),
                              Vec3(0.5, 1, 2).normalized().cross(Vec3(2, -1, 0).normalized()),
                              1,
                              0.5};
  const AngleWave wave = discriminant(motion);
  for (const double t : {0.0, 0.25, 0.5, 0.875, 1.25, 1.625}) {
    const double chi = test::angle_at(t);
    const Vec3 around = std::cos(chi) * motion.zero + std::sin(chi) * motion.quarter;
    const Vec3 a = motion.second.center - motion.first.center + motion.second.radius * around;
    const Vec3 b = motion.second.normal + motion.second.slope * around;
    const double half = product(motion.first, a, 1, b, 0);
    const double truth =
        half * half - product(motion.first, a, 1, a, 1) * product(motion.first, b, 0, b, 0);
    const Interval found = wave_jet<1>(wave, turn_stretch({t, t}).value())[0];
    EXPECT_TRUE(holds(found, truth, 1e-12)) << t;
    EXPECT_LT(found.upper - found.lower, 1e-11);
  }
}

}  // namespace
}  // namespace dupin::verification
