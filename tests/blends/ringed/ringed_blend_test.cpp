#include "dupin/blends/ringed_blend.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/ringed/ringed_blends.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using test::cone_to_cylinder;
using test::end_cone;
using test::general_ends;
using test::least_margin;
using test::start_cone;

void expect_point(const RationalRingedSurface& surface, double t, double v, const Vec3& expected) {
  EXPECT_LT((evaluate(surface, t, v).position - expected).norm(), 2e-14);
}

TEST(RingedBlend, of_a_cone_and_a_cylinder_is_that_of_the_table) {
  const RationalRingedSurface s = cone_to_cylinder();
  EXPECT_LT((s.center[1] - Vec3(-.24, 0, 1.2)).norm(), 1e-15);
  EXPECT_LT((s.center[2] - Vec3(2.8333333333333333, 1, 3.5)).norm(), 1e-15);
  EXPECT_NEAR(s.radius[1], 1.4, 1e-15);
  EXPECT_EQ(s.radius[2], .8);
  for (std::size_t i = 0; i < 4; ++i) {
    const double half = std::sqrt(.5);
    const std::array<double, 4> expected =
        i < 2 ? std::array<double, 4>{.5, -.5, -.5, -.5} : std::array<double, 4>{half, -half, 0, 0};
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_NEAR(s.rotation[i][j], expected[j], 1e-15);
    }
  }
  expect_point(s, .25, .5, Vec3(1.33152666112325, 0.70159655016228, 0.82501968411857));
  expect_point(s, .5, 2, Vec3(1.16352673740360, 1.45476229816697, 2.50897326259641));
  expect_point(s, .75, 4, Vec3(2.71650466420453, 0.17208778541421, 3.68663560385524));
  EXPECT_LT(
      (evaluate(s, .5, 2).normal - Vec3(-0.336787736925, 0.907608779708, 0.250639827749)).norm(),
      2e-12);
  EXPECT_NEAR(volume(s), 17.5269642058763, 1e-13);
  EXPECT_NEAR(area(s), 35.557668023709, 1e-12);
  EXPECT_NEAR(least_margin(s), 3.229860707, 6e-10);
}

TEST(RingedBlend, of_canal_ends_in_low_degree_is_that_of_the_table) {
  const RationalRingedSurface s = canal_ringed_blend(start_cone(), end_cone());
  EXPECT_EQ(s.rotation.size(), 2u);
  EXPECT_LT((s.center[1] - Vec3(-0.14907119849998593, 0, 5. / 3)).norm(), 1e-15);
  EXPECT_LT((s.center[2] - Vec3(3.6988660455426636, 1, 2.042932505167996)).norm(), 2e-15);
  EXPECT_NEAR(s.radius[1], 1.4166666666666667, 1e-15);
  EXPECT_NEAR(s.radius[2], .85, 1e-15);
  expect_point(s, .25, .5, Vec3(1.41609691254818, 0.70684026699076, 0.51602517661791));
  expect_point(s, .5, 2, Vec3(1.76076121846141, 1.45476229816697, 1.90692338779718));
  EXPECT_NEAR(volume(s), 16.8336089321639, 1e-13);
  EXPECT_NEAR(area(s), 35.52817062347, 1e-11);
  EXPECT_NEAR(least_margin(s), 2.059432329, 6e-10);
}

TEST(RingedBlend, of_general_ends_is_that_of_the_table) {
  const RationalRingedSurface s = general_ends();
  expect_point(s, .5, 2, Vec3(0.77496288771281, 2.37224979612578, 1.76981747688730));
  EXPECT_NEAR(volume(s), 15.3753836314577, 1e-13);
  EXPECT_NEAR(area(s), 34.305879365158, 1e-12);
  EXPECT_NEAR(least_margin(s), 3.301534162, 6e-10);
}

TEST(RingedBlend, meets_its_ends_with_the_rates_asked_for) {
  const RationalRingedSurface s = general_ends();
  const MovingRing start = ring_at(s, 0);
  EXPECT_LT((start.normal - Vec3::UnitZ()).norm(), 1e-15);
  EXPECT_LT((start.center_rate - Vec3(.5, .2, 4)).norm(), 1e-15);
  EXPECT_NEAR(start.radius_rate, -.6, 1e-14);
  EXPECT_LT((start.normal_rate - Vec3(.4, -.1, 0)).norm(), 1e-14);
  const Vec3 normal = Vec3(1, 1, .2).normalized();
  EXPECT_LT((ring_at(s, 1).normal - normal).norm(), 1e-15);
  EXPECT_LT((ring_at(s, 1).normal_rate - .3 * normal.cross(Vec3::UnitZ())).norm(), 1e-14);
}

TEST(RingedBlend, has_the_normals_of_its_neighbours) {
  const RationalRingedSurface oblique = cone_to_cylinder();
  const RationalRingedSurface right = canal_ringed_blend(start_cone(), end_cone());
  for (double v = 0; v < 6; v += .3) {
    // On the oblique cone: along the ruling and along the ring.
    const SurfacePoint a = evaluate(oblique, 0, v);
    EXPECT_NEAR(a.normal.dot((a.position - Vec3(.6, 0, -3)).normalized()), 0, 1e-15);
    EXPECT_NEAR(evaluate(oblique, 1, v).normal.x(), 0, 1e-15);
    // A right cone's normal has the same part along the axis everywhere: -sin of the half angle.
    EXPECT_NEAR(evaluate(right, 0, v).normal.z(), -std::sin(std::atan(.25)), 1e-15);
    EXPECT_NEAR(evaluate(right, 1, v).normal.dot(Vec3(.8, 0, -.6)), std::sin(std::atan(.15)),
                1e-15);
  }
}

TEST(RingedBlend, touches_a_sphere_and_an_oblique_cylinder) {
  const Vec3 center(0, 0, .75), direction(1, .3, 0);
  const RationalRingedSurface s =
      ringed_blend(along_sphere({Vec3(0, 0, 0), Vec3::UnitZ(), 1}, center, 3),
                   along_oblique_cylinder({Vec3(4, 1, 4), Vec3::UnitX(), .8}, direction, 3));
  for (double v = 0; v < 6; v += .3) {
    const SurfacePoint x = evaluate(s, 0, v);
    EXPECT_LT((x.normal - (x.position - center).normalized()).norm(), 1e-14);
    EXPECT_NEAR(evaluate(s, 1, v).normal.dot(direction), 0, 1e-14);
  }
}

TEST(RingedBlend, refuses_what_cannot_be) {
  const TravelRing ring{Vec3(0, 0, 0), Vec3::UnitZ(), 1};
  const TravelRing opposite{Vec3(0, 3, 0), -Vec3::UnitZ(), 1};
  EXPECT_THROW((void)along_canal(ring, 0, 0), Error);
  EXPECT_THROW((void)along_sphere(ring, Vec3(.1, 0, 1), 1), Error);
  EXPECT_THROW((void)along_oblique_cylinder({Vec3(0, 0, 0), Vec3(0, 0, 2), 1}, Vec3::UnitZ(), 1),
               Error);
  try {
    (void)ringed_blend(along_canal(ring, 0, 1), along_canal(opposite, 0, 1));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
  }
}

TEST(RingedBlend, of_canal_ends_turns_as_its_quaternion_of_degree_one_does) {
  // The normals stay in one plane: that of both ends.
  const RationalRingedSurface s = canal_ringed_blend(start_cone(), end_cone());
  const Vec3 across = start_cone().ring.normal.cross(end_cone().ring.normal);
  for (const double t : {.1, .5, .9}) {
    EXPECT_NEAR(ring_at(s, t).normal.dot(across), 0, 1e-15);
  }
}

TEST(RingedBlend, refuses_discs_that_overlap) {
  // Both rings look along z, one above the other by less than a slow start takes back.
  const auto code = [](double speed) {
    try {
      (void)ringed_blend(along_canal({Vec3(0, 0, 0), Vec3::UnitZ(), 1}, 0, speed),
                         along_canal({Vec3(0, 0, -1), Vec3::UnitZ(), 1}, 0, speed));
    } catch (const Error& error) {
      return error.code();
    }
    return Errc::io_failed;
  };
  EXPECT_EQ(code(1), Errc::irregular_surface);
  EXPECT_EQ(code(50), Errc::irregular_surface);
}

TEST(RingedBlend, refuses_rates_that_are_no_numbers) {
  MovingRing ring = along_canal({Vec3(0, 0, 0), Vec3::UnitZ(), 1}, 0, 3);
  const MovingRing to = along_canal({Vec3(0, 0, 3), Vec3::UnitZ(), 1}, 0, 3);
  EXPECT_NO_THROW((void)ringed_blend(ring, to));
  ring.radius_rate = std::nan("");
  EXPECT_THROW((void)ringed_blend(ring, to), Error);
}

}  // namespace
}  // namespace dupin
