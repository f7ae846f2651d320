#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "blends/canal/residuals.h"
#include "dupin/blends/canal_fillet.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using test::kPi;

Ring ring(const Vec3& center, const Vec3& normal, double radius, double slope = 0) {
  return {center, normal.normalized(), radius, slope};
}

/// Two quadrics that cross at a random angle and offset, anywhere in space; the first is thicker.
std::array<Ring, 2> random_crossing(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform;
  const test::Placement place = test::random_placement(random);
  const double psi = .8 + (kPi - 1.6) * uniform(random);
  const double slope = .2 * uniform(random) - .1, other = .2 * uniform(random) - .1;
  return {place(ring(Vec3(uniform(random), 0, .8 * uniform(random) - .4), Vec3::UnitX(), 3, slope)),
          place(ring(Vec3::Zero(), Vec3(std::cos(psi), std::sin(psi), 0), 1.5, other))};
}

TEST(RationalFillet, TouchesBothQuadricsInAnyPosition) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> uniform(.1, .4);
  int made = 0;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const auto quadrics = random_crossing(random);
    const std::array<double, 4> radii{uniform(random), uniform(random), uniform(random),
                                      uniform(random)};
    for (const int side : {1, -1}) {
      CanalFillet fillet;
      try {
        fillet = rational_fillet(quadrics, radii, side);
      } catch (const Error& error) {  // folds, or wants radii that change too much
        EXPECT_EQ(error.code(), Errc::irregular_surface);
        continue;
      }
      ++made;
      EXPECT_LT(test::residual(fillet), 1e-13);
      for (int k = 0; k < 4; ++k) {
        EXPECT_NEAR(ball(fillet, k * kPi / 2).radius, radii.at(k), 1e-13);
      }
      EXPECT_LT((ball(fillet, 1).center - ball(fillet, 1 + 2 * kPi).center).norm(), 1e-13);
    }
  }
  EXPECT_GT(made, 300);
}

TEST(RationalFillet, HasTheStatedDerivatives) {
  std::mt19937 random(22);
  for (int i = 0; i < 40; ++i) {
    for (const CanalFillet& fillet : rational_fillets(random_crossing(random), .3)) {
      for (const double t : {.1, 1.2, 2.9, 4.7}) {
        EXPECT_LT(test::derivative_error(fillet, t, 1e-3), 1e-8) << i << " at " << t;
      }
    }
  }
  for (const double t : {.1, 1.2, 2.9, 4.7}) {
    const auto parallel = rational_fillets(
        {ring(Vec3(2, 0, 0), Vec3::UnitY(), 1), ring(Vec3(-2, 1, 0), Vec3::UnitY(), 1, 1)}, .5);
    ASSERT_EQ(parallel.size(), 1);
    EXPECT_LT(test::derivative_error(parallel[0], t, 1e-3), 1e-8) << t;
  }
}

TEST(RationalFillet, KeepsTheOrderOfTheQuadrics) {
  std::mt19937 random(23);
  const auto quadrics = random_crossing(random);
  const CanalFillet one = rational_fillet(quadrics, {.3, .3, .3, .3}, 1);
  const CanalFillet two = rational_fillet({quadrics[1], quadrics[0]}, {.3, .3, .3, .3}, 1);
  EXPECT_EQ(two.quadrics[0], quadrics[1]);
  EXPECT_LT((ball(one, 1).center - ball(two, 1).center).norm(), 1e-13);
  EXPECT_LT((contact_arc(one.quadrics, ball(one, 1)).feet[0] -
             contact_arc(two.quadrics, ball(two, 1)).feet[1])
                .norm(),
            1e-13);
}

TEST(RationalFillet, OfParallelConesSurroundsTheFirst) {
  const Ring pipe = ring(Vec3(2, 0, 0), Vec3::UnitY(), 1);
  const Ring cone = ring(Vec3(-2, 1, 0), Vec3::UnitY(), 1, 1);
  const CanalFillet fillet = rational_fillet({pipe, cone}, {.5, .7, .6, .7}, 1);
  EXPECT_NEAR(ball(fillet, 0).radius, .5, 1e-14);
  EXPECT_NEAR(ball(fillet, kPi).radius, .6, 1e-14);
  EXPECT_NEAR(ball(fillet, 0).center.x(), 3.5, 1e-13);
  EXPECT_NEAR(ball(fillet, kPi).center.x(), .4, 1e-13);
  EXPECT_LT(test::residual(fillet), 1e-14);
  // Against the closed form of B.6 by the balls' own places.
  for (const double t : {.5, 1.5, 2.5}) {
    const MovingBall at = ball(fillet, t);
    EXPECT_NEAR(std::hypot(at.center.x() - 2, at.center.z()), 1 + at.radius, 1e-13);
    EXPECT_NEAR(std::hypot(at.center.x() + 2, at.center.z()),
                at.center.y() + std::sqrt(2.0) * at.radius, 1e-13);
  }
}

void expect_refused(const std::array<Ring, 2>& quadrics, const std::array<double, 4>& radii,
                    int side, Errc code, const std::string& why) {
  try {
    (void)rational_fillet(quadrics, radii, side);
    ADD_FAILURE() << "not refused: " << why;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    EXPECT_NE(error.message().find(why), std::string::npos) << error.message();
  }
}

TEST(RationalFillet, SaysWhyThereIsNone) {
  const Ring run = ring(Vec3::Zero(), Vec3::UnitX(), 2);
  const Ring branch = ring(Vec3::Zero(), Vec3::UnitY(), 1);
  const std::array<double, 4> radii{.3, .3, .3, .3};
  expect_refused({run, ring(Vec3(0, 2, 0), -Vec3::UnitX(), 1)}, radii, 1, Errc::irregular_surface,
                 "parallel");
  expect_refused({run, ring(Vec3(0, 0, 1.5), Vec3::UnitY(), 1)}, radii, 1, Errc::irregular_surface,
                 "leaves it partly");
  expect_refused({run, ring(Vec3(0, 0, 1), Vec3::UnitY(), 1)}, radii, 1, Errc::irregular_surface,
                 "touches the other from inside");
  expect_refused({run, ring(Vec3::Zero(), Vec3::UnitY(), 2)}, radii, 1, Errc::irregular_surface,
                 "touches the other from inside");
  expect_refused({run, branch}, {3, .1, 3, .1}, 1, Errc::irregular_surface, "folds");
  expect_refused({run, branch}, {.3, 0, .3, .3}, 1, Errc::invalid_argument, "positive");
  expect_refused({run, branch}, radii, 0, Errc::invalid_argument, "side");
  const Ring cone = ring(Vec3(0, 4, 0), Vec3::UnitY(), 1, .5);
  expect_refused({ring(Vec3::Zero(), Vec3::UnitY(), 5), cone}, radii, 1, Errc::irregular_surface,
                 "share an axis");
  expect_refused({ring(Vec3(1, 0, 0), Vec3::UnitY(), 5), cone}, radii, 1, Errc::irregular_surface,
                 "no ball of radius");
}

}  // namespace
}  // namespace dupin
