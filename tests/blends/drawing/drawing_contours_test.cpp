#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/tubes.h"
#include "dupin/blends/cyclide_piece.h"
#include "dupin/blends/drawing.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using std::numbers::pi;

double length(const ContourCurve& curve) {
  double sum = 0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    sum += (curve[i].position - curve[i - 1].position).norm();
  }
  return sum;
}

double distance(const Vec3& p, const std::vector<ContourCurve>& curves) {
  double least = std::numeric_limits<double>::infinity();
  for (const ContourCurve& curve : curves) {
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const Vec3 a = curve[i - 1].position, along = curve[i].position - a;
      const double s = std::clamp(along.dot(p - a) / along.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (a + s * along - p).norm());
    }
  }
  return least;
}

TEST(Contour, of_a_ball_is_a_great_circle) {
  const Vec3 direction(1, -2, 4);
  const auto curves = contours(Sphere{{1, 2, 3}, 5}, direction, 1e-3);
  ASSERT_EQ(curves.size(), 1);
  EXPECT_EQ(curves[0].front().position, curves[0].back().position);
  for (const ContourPoint& point : curves[0]) {
    EXPECT_NEAR((point.position - Vec3(1, 2, 3)).norm(), 5, 1e-14);
    EXPECT_NEAR(point.normal.dot(direction), 0, 1e-14);
  }
  EXPECT_NEAR(length(curves[0]), 2 * pi * 5, 2 * pi * 1e-3);
}

TEST(Contour, of_a_cylinder_is_two_generators_and_none_along_its_axis) {
  const RingedSurface tube = test::cylinder({0, 0, 0}, {10, 0, 0}, 2);
  const auto curves = contours(tube, {1, 0, -3}, 1e-6);
  ASSERT_EQ(curves.size(), 2);
  for (const ContourCurve& curve : curves) {
    EXPECT_NEAR(length(curve), 10, 1e-12);
    for (const ContourPoint& point : curve) {
      EXPECT_NEAR(std::abs(point.position[1]), 2, 1e-14);
      EXPECT_NEAR(point.normal[1], point.position[1] / 2, 1e-14);
    }
  }
  EXPECT_TRUE(contours(tube, {1, 0, 0}, 1e-6).empty());
  const RingedSurface slant = test::cylinder({1, 2, 3}, {4, 7, -5}, 2);
  EXPECT_TRUE(contours(slant, {3, 5, -8}, 1e-6).empty());
}

// Seen from within the angle of its sides, a cone has no contour.
TEST(Contour, of_a_cone_depends_on_where_it_is_seen_from) {
  const RingedSurface cone = test::cone({0, 0, 0}, {0, 0, 10}, 5, 1);
  const double slope = 0.4;
  for (const double turn : {0.0, 0.3, 0.39, 0.41, 1.0, 5.0}) {
    const auto curves = contours(cone, {turn, 0, 1}, 1e-6);
    EXPECT_EQ(curves.size(), turn > slope ? 2 : 0) << turn;
    for (const ContourCurve& curve : curves) {  // normal (cos u, sin u, slope) . w = 0
      EXPECT_NEAR(std::cos(std::atan2(curve[0].position[1], curve[0].position[0])), -slope / turn,
                  1e-11);
    }
  }
}

// A torus of radii R > r seen along a direction at right angles to its axis: circles at both ends
// of the vertical diameters, and the outer and inner ones.
TEST(Contour, of_an_elbow_in_its_plane_is_the_two_circles_of_its_plane) {
  const auto curves = contours(test::elbow(10, pi / 2, 3), {0, 0, 1}, 1e-5);
  std::vector<double> lengths;
  for (const ContourCurve& curve : curves) {
    lengths.push_back(length(curve));
  }
  std::ranges::sort(lengths);
  ASSERT_EQ(lengths.size(), 2);
  EXPECT_NEAR(lengths[0], 7 * pi / 2, 1e-4);
  EXPECT_NEAR(lengths[1], 13 * pi / 2, 1e-4);
}

// Along the direction in which it ends, all of its rim there, once, and the circle in between that
// is furthest up and down.
TEST(Contour, of_an_elbow_along_its_end_has_the_rim) {
  for (const Vec3& along : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
    const auto elbow = test::elbow(10, pi / 2, 3);
    const Ring &start = elbow.start, &end = elbow.end;
    int rims = 0;
    for (const ContourCurve& curve : contours(elbow, along, 1e-5)) {
      for (const Ring& ring : {start, end}) {
        const bool is_rim = std::ranges::all_of(curve, [&](const ContourPoint& point) {
          return std::abs((point.position - ring.center).dot(ring.normal)) < 1e-9;
        });
        if (is_rim) {
          ++rims;
          EXPECT_GT(std::abs(ring.normal.dot(along)), 1 - 1e-12);
          EXPECT_NEAR(length(curve), 6 * pi, 1e-3);
        }
      }
    }
    EXPECT_EQ(rims, 1);
  }
}

// [SD94], mathematics A10: on the characteristic circle of a canal surface with unit tangent
// (A; tau), u = -tau A_w / |A_w|^2 +- sqrt(1 - tau^2 / |A_w|^2) w x A_w / |A_w|.
TEST(Contour, of_cyclides_is_what_the_closed_form_says) {
  const PeVector start{{0, 0, 0}, 1}, end{{4, 3, 1}, 0.6};
  const Vec3 axis = Vec3(1, 0.1, 0).normalized();
  const PeArc arc = PeArc::from(start, {axis, 0}, end);
  const Vec3 w = Vec3(0.3, 0.5, -1).normalized();
  const auto curves = contours(cyclide_piece(arc), w, 1e-7);
  ASSERT_EQ(curves.size(), 2);
  for (int i = 0; i <= 40; ++i) {
    const double t = i / 40.;
    const PeVector sphere = sphere_at(arc, t), tangent = tangent_at(arc, t);
    const Vec3 flat = tangent.m - tangent.m.dot(w) * w;
    const double squared = flat.squaredNorm();
    for (const double side : {-1., 1.}) {
      const Vec3 u =
          -tangent.r / squared * flat + side * std::sqrt(1 - tangent.r * tangent.r / squared) *
                                            w.cross(flat) / std::sqrt(squared);
      EXPECT_LT(distance(sphere.m + sphere.r * u, curves), 1e-6);
    }
  }
}

TEST(Contour, refuses_bad_arguments) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Sphere ball{{0, 0, 0}, 1};
  EXPECT_THROW((void)contours(ball, {0, 0, 0}, 1), Error);
  EXPECT_THROW((void)contours(ball, {0, nan, 0}, 1), Error);
  for (const double bad : {0., -1., nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)contours(ball, {0, 0, 1}, bad), Error);
  }
}

}  // namespace
}  // namespace dupin
