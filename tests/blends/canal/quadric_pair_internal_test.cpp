#include <cmath>

#include <gtest/gtest.h>

#include "canal/quadric_pair.h"
#include "dupin/kernel/error.h"

namespace dupin::canal {
namespace {

Ring ring(const Vec3& center, const Vec3& normal, double radius, double slope = 0) {
  return {center, normal, radius, slope};
}

TEST(QuadricPair, OfCylindersHasAnglesAndDistancesOfAxes) {
  const QuadricPair pair = quadric_pair(
      {ring(Vec3(7, 0, .25), Vec3::UnitX(), 2), ring(Vec3(3, 4, -.25), Vec3(.6, .8, 0), 1)});
  EXPECT_DOUBLE_EQ(pair.cosine, .6);
  EXPECT_DOUBLE_EQ(pair.squared_sine, .64);
  EXPECT_LT((pair.nearest[0].m - Vec3(0, 0, .25)).norm(), 1e-14);
  EXPECT_LT((pair.nearest[1].m - Vec3(0, 0, -.25)).norm(), 1e-14);
  EXPECT_DOUBLE_EQ(pair.apart.r, 1);
  EXPECT_DOUBLE_EQ(pair.squared_distance, .25 - 1);
  EXPECT_EQ(passed_through(pair), 0);
}

TEST(QuadricPair, OfCylinderAndConeIsAsInTheClosedForm) {
  // Mathematics B.5: db = |r1 - R_O| sin psi / sqrt(sin^2 psi - sin^2 phi), R_O = 8 sin phi.
  const double phi = 10 * std::acos(-1.0) / 180, slope = std::tan(phi), psi = std::acos(-1.0) / 3;
  const Vec3 away(std::cos(psi), std::sin(psi), 0);
  const QuadricPair pair = quadric_pair(
      {ring(8 * away - away / slope, -away, 1, slope), ring(Vec3::Zero(), Vec3::UnitX(), 2)});
  EXPECT_NEAR(std::sqrt(-pair.squared_distance), 0.623476565341051, 1e-14);
  EXPECT_EQ(passed_through(pair), 1);
}

TEST(QuadricPair, OfParallelAxesSpansATimelikePlane) {
  const QuadricPair pair = quadric_pair(
      {ring(Vec3(2, 0, 0), Vec3::UnitY(), 1), ring(Vec3(-2, 5, 0), Vec3::UnitY(), 5, 1)});
  EXPECT_NEAR(pair.squared_sine, -1, 1e-15);
  EXPECT_NEAR(pair.squared_distance, 16, 1e-13);
  EXPECT_THROW((void)passed_through(pair), Error);
}

TEST(QuadricPair, RefusesWhatNoBallRunsAround) {
  const Ring run = ring(Vec3::Zero(), Vec3::UnitX(), 2);
  EXPECT_THROW((void)quadric_pair({run, ring(Vec3(0, 1, 0), -Vec3::UnitX(), 1)}), Error);
  EXPECT_THROW(require_positive(0), Error);
  EXPECT_THROW(require_positive(std::nan("")), Error);
  for (const double height : {1.5, 1.0, 0.9999999}) {  // partly, touching, nearly touching
    EXPECT_THROW(
        (void)passed_through(quadric_pair({run, ring(Vec3(0, 0, height), Vec3::UnitY(), 1)})),
        Error)
        << height;
  }
}

}  // namespace
}  // namespace dupin::canal
