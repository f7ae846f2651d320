#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"

namespace dupin {
namespace {

using std::numbers::pi;
using test::lune_spheres;
using test::sphere;

double distance(const PeVector& a, const PeVector& b) {
  return std::hypot((a.m - b.m).norm(), a.r - b.r);
}

TEST(ThroughAll, pieces_have_the_oracle_values) {
  // Mathematics C9.
  const std::vector<PeArc> pieces = through_all(lune_spheres());
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(pieces[0].w(), 0.911576107807702, 1e-12);
  EXPECT_NEAR(pieces[0].chord(), 4.12310562561766, 1e-12 * 4);
  EXPECT_NEAR(pieces[0].least_power(), 12.0513487498862, 1e-12 * 12);
  EXPECT_LT(distance(pieces[0].start_tangent(),
                     sphere(0.77490838713531, 0.658891029739346, 0, -0.186065573182207)),
            1e-12);
  EXPECT_LT(distance(pieces[0].end_tangent(),
                     sphere(0.993809061467319, -0.216711667588688, 0, 0.186065573182207)),
            1e-12);
  EXPECT_NEAR(pieces[1].w(), 0.723730800098602, 1e-12);
  EXPECT_NEAR(pieces[1].chord(), 3.98873413503583, 1e-12 * 4);
  EXPECT_NEAR(pieces[1].least_power(), 10.9157103774936, 1e-12 * 11);
  EXPECT_LT(distance(pieces[1].start_tangent(),
                     sphere(0.722515452454678, -0.691441855552116, 0, -0.0109735429620936)),
            1e-12);
  const CanonicalCyclide first = canonical_form(pieces[0]), second = canonical_form(pieces[1]);
  EXPECT_NEAR(first.a, 5.503954159963, 1e-11);
  EXPECT_NEAR(first.c, 2.269338436009, 1e-11);
  EXPECT_NEAR(first.mu, 3.068674698795, 1e-11);
  EXPECT_NEAR(second.a, 2.903913992654, 1e-11);
  EXPECT_NEAR(second.c, 0.2835036664999, 1e-11);
  EXPECT_NEAR(second.mu, 0.7182757532734, 1e-11);
  // The middle sphere belongs to the piece, at the parameter that the tangential distances give.
  const auto spheres = lune_spheres();
  const double c01 = std::sqrt(squared_tangential_distance(spheres[0], spheres[1]));
  const double c12 = std::sqrt(squared_tangential_distance(spheres[1], spheres[2]));
  EXPECT_LT(distance(sphere_at(pieces[0], c01 / (c01 + c12)), spheres[1]), 1e-12);
}

TEST(Kneecap, has_the_oracle_values) {
  const std::vector<PeArc> pieces = through_all(lune_spheres());
  const SphericalJoint knee = spherical_joint(pieces[0], pieces[1]);
  const double degree = pi / 180;
  EXPECT_NEAR(knee.before, 79.4597606664767 * degree, 1e-12);
  EXPECT_NEAR(knee.after, 89.3712875373905 * degree, 1e-12);
  EXPECT_NEAR(knee.between, 148.56039319103 * degree, 1e-12);
  EXPECT_NEAR(knee.overlap_area, 0.552007223862494, 1e-12);
  EXPECT_NEAR(knee.exposed_area, 1.77031001528072, 1e-12);
  EXPECT_FALSE(knee.is_clean());
}

TEST(Kneecap, areas_are_those_of_random_directions) {
  const std::vector<PeArc> pieces = through_all(lune_spheres());
  const SphericalJoint knee = spherical_joint(pieces[0], pieces[1]);
  const PeVector back = pieces[0].end_tangent(), ahead = pieces[1].start_tangent();
  std::mt19937_64 random(13);
  std::normal_distribution<double> normal;
  constexpr int kCount = 400'000;
  int both = 0, none = 0;
  for (int i = 0; i < kCount; ++i) {
    const Vec3 u = Vec3(normal(random), normal(random), normal(random)).normalized();
    const bool is_behind = u.dot(back.m)<-back.r, is_ahead = u.dot(ahead.m)> - ahead.r;
    both += is_behind && is_ahead ? 1 : 0;
    none += is_behind || is_ahead ? 0 : 1;
  }
  // Four standard deviations of the counts.
  const auto expect_share = [](int count, double area) {
    const double share = area / (4 * pi);
    EXPECT_NEAR(double(count) / kCount, share, 4 * std::sqrt(share / kCount));
  };
  expect_share(both, knee.overlap_area);
  expect_share(none, knee.exposed_area);
}

TEST(Kneecap, of_pieces_that_meet_g1_is_a_circle) {
  const CyclideChain hook = test::crane_hook();
  const SphericalJoint knee = spherical_joint(hook.pieces[2], hook.pieces[3]);
  EXPECT_NEAR(knee.between, pi, 1e-7);  // the angle of opposite vectors has half the digits
  EXPECT_NEAR(knee.before + knee.after, pi, 1e-14);
  EXPECT_NEAR(knee.exposed_area, 0, 1e-12);
  EXPECT_NEAR(knee.overlap_area, 0, 1e-12);
  EXPECT_THROW((void)spherical_joint(hook.pieces[3], hook.pieces[2]), Error);
}

TEST(ThroughAll, names_the_piece_that_fails) {
  auto spheres = lune_spheres();
  spheres[3].r = 5;
  try {
    (void)through_all(spheres);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.part(), "piece 1");
  }
  EXPECT_THROW((void)through_all(std::span(spheres).first(2)), Error);
}

}  // namespace
}  // namespace dupin
