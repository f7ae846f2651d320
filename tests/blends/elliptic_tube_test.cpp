#include "dupin/blends/elliptic_tube.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/two_cone_spine.h"
#include "dupin/kernel/error.h"
#include "support/paper_surfaces.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

const EllipticRing kFrom{Vec3(0, 0, 0), Vec3::UnitX(), Vec3(0, .6, .8), 1.2, .7};

EllipticRing outlet(double first, double second) {
  const Vec3 normal = -test::skew_axis();
  const Vec3 axis = normal.cross(Vec3(1, .3, .2)).normalized();
  return {Vec3(10, 4, 0), normal, axis, first, second};
}

// How far x is off the elliptic cylinder about the ring, in multiples of its semi-axes, squared.
double off_cylinder(const EllipticRing& ring, const Vec3& x) {
  const Vec3 across = ring.normal.cross(ring.axis), d = x - ring.center;
  return std::pow(d.dot(ring.axis) / ring.first, 2) + std::pow(d.dot(across) / ring.second, 2) - 1;
}

TEST(EllipticTube, of_circles_is_the_ringed_surface) {
  const RingedSurface round = test::figure6();
  const EllipticTube tube{{}, {}, round.spine, round.radius, round.radius, /*turn=*/0.7, {}};
  const FrameField field(round.spine, Vec3::UnitY());
  for (const double t : {0., .3, .8}) {
    const double turned = .7 * t * t * (3 - 2 * t);
    const SurfacePoint a = evaluate(round, field, t, 1 + turned), b = evaluate(tube, field, t, 1);
    EXPECT_LT((a.position - b.position).norm(), 1e-14);
    EXPECT_LT((a.normal - b.normal).norm(), 1e-14);
    EXPECT_NEAR(margin_at(tube, field, t),
                1 - curvature(evaluate(round.spine, t)) * evaluate(round.radius, t).value, 1e-14);
  }
  EXPECT_NEAR(volume(tube), volume(round), 1e-12);
}

TEST(EllipticTube, has_the_derivatives_and_normal_of_its_points) {
  const EllipticTube tube = elliptic_blend(kFrom, outlet(1.5, .8), {.k = 10, .l = 20, .margin = 0});
  const FrameField field = frames(tube);
  const double h = 1e-5;
  for (const double t : {.1, .5, .9}) {
    for (const double u : {.3, 2., 5.}) {
      const SurfacePoint x = evaluate(tube, field, t, u);
      const auto at = [&](double s, double w) { return evaluate(tube, field, s, w).position; };
      EXPECT_LT(((at(t + h, u) - at(t - h, u)) / (2 * h) - x.along).norm(), 1e-6);
      EXPECT_LT(((at(t, u + h) - at(t, u - h)) / (2 * h) - x.around).norm(), 1e-8);
      EXPECT_LT((x.around.cross(x.along).normalized() - x.normal).norm(), 1e-13);
    }
  }
}

TEST(EllipticTube, ends_on_its_rings_tangent_to_their_cylinders) {
  for (const EllipticRing& to : {outlet(1.5, .8), outlet(.8, 1.5), outlet(1.1, 1.1)}) {
    const EllipticTube tube = elliptic_blend(kFrom, to, {.k = 10, .l = 20, .margin = 0});
    EXPECT_EQ(tube.start, flipped(kFrom));
    EXPECT_EQ(tube.end, flipped(to));
    EXPECT_LE(std::abs(tube.turn), kPi / 2);
    const FrameField field = frames(tube);
    for (double u = 0; u < 6; u += .4) {
      for (const double t : {0., 1.}) {
        const EllipticRing& ring = t == 0 ? kFrom : to;
        const SurfacePoint x = evaluate(tube, field, t, u);
        EXPECT_NEAR(off_cylinder(ring, x.position), 0, 1e-14);
        const Vec3 across = ring.normal.cross(ring.axis), d = x.position - ring.center;
        const Vec3 normal = (d.dot(ring.axis) / std::pow(ring.first, 2) * ring.axis +
                             d.dot(across) / std::pow(ring.second, 2) * across)
                                .normalized();
        EXPECT_LT((x.normal - normal).norm(), 1e-14);
      }
    }
  }
}

TEST(EllipticTube, stays_near_the_cylinder_to_the_order_of_its_continuity) {
  EllipticRing far = outlet(1.5, .8);
  far.center = Vec3(20, 8, 10);
  const auto deviation = [&](Continuity continuity, double t) {
    const EllipticTube tube =
        elliptic_blend(kFrom, far, {.k = 25, .l = 25, .margin = 0, .continuity = continuity});
    const FrameField field = frames(tube);
    double largest = 0;
    for (double u = 0; u < 6; u += .3) {
      largest =
          std::max(largest, std::abs(off_cylinder(kFrom, evaluate(tube, field, t, u).position)));
    }
    return largest;
  };
  EXPECT_NEAR(deviation(Continuity::g1, .02) / deviation(Continuity::g1, .01), 4, .5);
  EXPECT_NEAR(deviation(Continuity::g2, .02) / deviation(Continuity::g2, .01), 8, .8);
}

// The angle between the tube's normals in the Frenet frame and the cylinder's at an end, where the
// frame spins with v tau [BWL17]; the largest of 720 around, as tabulated.
double frenet_defect(const Spine& spine, double t, double a, double b) {
  const SpinePoint y = evaluate(spine, t);
  const Vec3 bend = y.first.cross(y.second);
  const double v = y.first.norm(), kappa = curvature(y);
  const double torsion = bend.dot(y.third) / bend.squaredNorm();
  double largest = 0;
  for (int i = 0; i < 720; ++i) {
    const double u = 2 * kPi * i / 720, c = std::cos(u), s = std::sin(u);
    largest = std::max(largest, std::abs(v * torsion * (a * a - b * b) * s * c /
                                         (v * (1 - kappa * a * c) * std::hypot(b * c, a * s))));
  }
  return std::atan(largest) * 180 / kPi;
}

TEST(EllipticTube, in_the_frenet_frame_would_not_be_tangent) {
  const std::array<Vec3, 4> vertices{Vec3(4, 0, 0), Vec3(4, 4, 0), Vec3(0, 4, 0), Vec3(0, 6, 5)};
  const Spine weighted = two_cone_spine(vertices, {1, 1, 1}, {1, 2, 1});
  EXPECT_NEAR(frenet_defect(weighted, 0, 1, .5), 0.430644854, 6e-10);
  EXPECT_NEAR(frenet_defect(weighted, 1, 1, .5), 0.2453918, 6e-8);
  const Spine plain = two_cone_spine(vertices, {1, 1, 1}, {1, 1, 1});
  EXPECT_NEAR(frenet_defect(plain, 0, 1, .5), 1.870132343, 6e-10);
  EXPECT_NEAR(frenet_defect(plain, 1, 1, .5), 0.981477301, 6e-10);
}

TEST(EllipticTube, on_the_two_cone_spine_is_tangent_in_its_own_frame) {
  const std::array<Vec3, 4> vertices{Vec3(4, 0, 0), Vec3(4, 4, 0), Vec3(0, 4, 0), Vec3(0, 6, 5)};
  const EllipticTube tube{{vertices[0], -Vec3::UnitY(), Vec3::UnitX(), 1, .5},
                          {},
                          two_cone_spine(vertices, {1, 1, 1}, {1, 1, 1}),
                          ConstantRadius{1},
                          ConstantRadius{.5},
                          .4};
  const FrameField field = frames(tube);
  for (const double t : {0., 1.}) {
    const Vec3 tangent = evaluate(tube.spine, t).first.normalized();
    for (double u = 0; u < 6; u += .3) {
      EXPECT_NEAR(evaluate(tube, field, t, u).normal.dot(tangent), 0, 1e-14);
    }
  }
}

TEST(EllipticTube, certifies_no_more_than_its_margin) {
  const EllipticTube tube = elliptic_blend(kFrom, outlet(1.5, .8), {.margin = 0});
  const FrameField field = frames(tube);
  double sampled = 1;
  for (int i = 0; i <= 500; ++i) {
    sampled = std::min(sampled, margin_at(tube, field, i / 500.));
  }
  EXPECT_LE(certified_margin(tube), sampled);
  EXPECT_GE(certified_margin(tube), 0);
}

TEST(EllipticTube, of_a_straight_spine_has_the_volume_of_the_cylinder) {
  const EllipticTube tube{
      {}, {}, LineSpine{Vec3(0, 0, 0), Vec3(0, 0, 5)}, ConstantRadius{2}, ConstantRadius{1}};
  EXPECT_NEAR(volume(tube), 10 * kPi, 1e-13);
}

TEST(EllipticTube, refuses_bad_rings) {
  EllipticRing slanted = kFrom, thin = kFrom;
  slanted.axis = Vec3(.1, .6, .8);
  thin.second = 0;
  EXPECT_THROW((void)elliptic_blend(slanted, outlet(1, 1)), Error);
  EXPECT_THROW((void)elliptic_blend(thin, outlet(1, 1)), Error);
}

}  // namespace
}  // namespace dupin
