#include "dupin/blends/elliptic_tube.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/spine.h"
#include "dupin/kernel/error.h"
#include "support/paper_surfaces.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

const Ring kFrom{Vec3(0, 0, 0), Vec3::UnitX(), 1.2, 0, Ellipse{Vec3(0, .6, .8), .7}};

Ring outlet(double first, double second) {
  const Vec3 normal = -test::skew_axis();
  const Vec3 axis = normal.cross(Vec3(1, .3, .2)).normalized();
  return {Vec3(10, 4, 0), normal, first, 0, Ellipse{axis, second}};
}

Ring round_outlet(double radius) { return {Vec3(10, 4, 0), -test::skew_axis(), radius}; }

// How far x is off the elliptic cylinder about the ring, in multiples of its semi-axes, squared.
double off_cylinder(const Ring& ring, const Vec3& x) {
  const Vec3 axis = reference_axis(ring), side = ring.normal.cross(axis), d = x - ring.center;
  return std::pow(d.dot(axis) / ring.radius, 2) + std::pow(d.dot(side) / across(ring), 2) - 1;
}

TEST(EllipticTube, of_circles_is_the_ringed_surface) {
  const RingedSurface round = test::figure6();
  const EllipticTube tube{{},          {}, round.spine, round.radius, round.radius, Vec3::UnitY(),
                          /*turn=*/0.7};
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
  for (const Ring& to : {outlet(1.5, .8), outlet(.8, 1.5), round_outlet(1.1)}) {
    const EllipticTube tube = elliptic_blend(kFrom, to, {.k = 10, .l = 20, .margin = 0});
    EXPECT_EQ(tube.start, flipped(kFrom));
    EXPECT_EQ(tube.end, flipped(to));
    EXPECT_LE(std::abs(tube.turn), kPi / 2);
    const FrameField field = frames(tube);
    for (double u = 0; u < 6; u += .4) {
      for (const double t : {0., 1.}) {
        const Ring& ring = t == 0 ? kFrom : to;
        const SurfacePoint x = evaluate(tube, field, t, u);
        EXPECT_NEAR(off_cylinder(ring, x.position), 0, 1e-14);
        const Vec3 axis = reference_axis(ring), side = ring.normal.cross(axis);
        const Vec3 d = x.position - ring.center;
        const Vec3 normal = (d.dot(axis) / std::pow(ring.radius, 2) * axis +
                             d.dot(side) / std::pow(across(ring), 2) * side)
                                .normalized();
        EXPECT_LT((x.normal - normal).norm(), 1e-14);
      }
    }
  }
}

TEST(EllipticTube, stays_near_the_cylinder_to_the_order_of_its_continuity) {
  Ring far = outlet(1.5, .8);
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
  const EllipticTube tube{{},
                          {},
                          two_cone_spine(vertices, {1, 1, 1}, {1, 1, 1}),
                          ConstantRadius{1},
                          ConstantRadius{.5},
                          Vec3::UnitX(),
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
  EXPECT_EQ(tangency_bound(tube, End::start), 0);
}

TEST(EllipticTube, of_a_straight_spine_has_the_volume_of_the_cylinder) {
  const EllipticTube tube{
      {}, {}, LineSpine{Vec3(0, 0, 0), Vec3(0, 0, 5)}, ConstantRadius{2}, ConstantRadius{1}};
  EXPECT_NEAR(volume(tube), 10 * kPi, 1e-13);
}

TEST(EllipticTube, between_a_circle_and_an_ellipse_does_not_turn) {
  const Ring circle{Vec3(0, 0, 0), Vec3::UnitX(), 1};
  const EllipticTube opening = elliptic_blend(circle, outlet(1.5, .8), {.k = 10, .l = 20});
  const EllipticTube closing = elliptic_blend(kFrom, round_outlet(1.4), {.margin = 0});
  EXPECT_EQ(opening.turn, 0);
  EXPECT_EQ(closing.turn, 0);
  const Frame arriving = frames(opening).at(1);
  EXPECT_NEAR(arriving.first.cross(opening.end.ellipse->axis).norm(), 0, 1e-14);
}

// An elliptic cone from (1, 2) to the ring's semi-axes over a length of 4.
TEST(EllipticTube, goes_on_from_an_elliptic_cone) {
  Ring from = kFrom;
  from.slope = .05;
  from.ellipse->across_slope = -.04;
  for (const auto continuity : {Continuity::g1, Continuity::g2}) {
    const EllipticTube tube =
        elliptic_blend(from, outlet(1.5, .8), {.margin = 0, .continuity = continuity});
    EXPECT_LT(tangency_bound(tube, End::start), 1e-14);
    EXPECT_EQ(tangency_bound(tube, End::end), 0);
    const FrameField field = frames(tube);
    const double speed = evaluate(tube.spine, 0).first.norm();
    for (double u = 0; u < 6; u += .5) {
      // The ruling of the cone through the point lies in the tube's tangent plane.
      const Vec3 side = from.normal.cross(from.ellipse->axis);
      const SurfacePoint x = evaluate(tube, field, 0, u);
      const Vec3 d = x.position - from.center;
      const double a = d.dot(from.ellipse->axis) / from.radius, b = d.dot(side) / across(from);
      const Vec3 ruling =
          from.normal + a * from.slope * from.ellipse->axis + b * across_slope(from) * side;
      EXPECT_NEAR(x.normal.dot(ruling), 0, 1e-14);
      EXPECT_NEAR(x.along.norm(), speed * ruling.norm(), 1e-13 * speed);
    }
  }
}

TEST(EllipticTube, refuses_bad_rings) {
  Ring slanted = kFrom, thin = kFrom;
  slanted.ellipse->axis = Vec3(.1, .6, .8);
  thin.ellipse->across = 0;
  EXPECT_THROW((void)elliptic_blend(slanted, outlet(1, 1)), Error);
  EXPECT_THROW((void)elliptic_blend(thin, outlet(1, 1)), Error);
}

}  // namespace
}  // namespace dupin
