#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/fitting/implicit_surfaces.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using std::numbers::pi;

double length(const std::vector<Vec3>& curve) {
  double sum = 0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    sum += (curve[i] - curve[i - 1]).norm();
  }
  return sum;
}

TEST(RingedFitContour, of_a_sphere_is_a_great_circle) {
  const Vec3 w(1, 2, -2);
  const auto curve = implicit_contour(test::sphere(3), w, {2, 1, 2}, {.step = 0.05});
  EXPECT_EQ(curve.front(), curve.back());
  EXPECT_NEAR(length(curve), 6 * pi, 6 * pi * 0.05 * 0.05 / 24 / 9 * 2);
  for (const Vec3& point : curve) {
    EXPECT_NEAR(point.norm(), 3, 1e-9);
    EXPECT_NEAR(point.dot(w), 0, 1e-8);
  }
}

TEST(RingedFitContour, of_a_torus_along_its_axis_is_both_circles) {
  const ImplicitSurface torus = test::torus(5, 1);
  EXPECT_NEAR(length(implicit_contour(torus, Vec3::UnitZ(), {6.1, 0.1, 0.1})), 12 * pi, 0.01);
  EXPECT_NEAR(length(implicit_contour(torus, Vec3::UnitZ(), {3.9, 0.1, 0.1})), 8 * pi, 0.01);
}

// However long the steps are that are asked for.
TEST(RingedFitContour, is_followed_where_it_turns_within_a_step) {
  for (const double step : {0.02, 0.5, 1., 3., 10., 1e3}) {
    const auto contour =
        implicit_contour(test::sphere(1), Vec3::UnitZ(), {1, 0.1, 0}, {.step = step});
    ASSERT_EQ(contour.front(), contour.back()) << step;
    double turned = 0;
    for (std::size_t i = 1; i < contour.size(); ++i) {
      EXPECT_NEAR(contour[i].norm(), 1, 1e-8);
      const double turn = std::asin(contour[i - 1].cross(contour[i]).z());
      EXPECT_LT(std::abs(turn), 1.5);
      turned += turn;
    }
    EXPECT_NEAR(std::abs(turned), 2 * std::numbers::pi, 1e-6) << step;
  }
}

TEST(RingedFitContour, is_refused_where_all_of_the_surface_is_one) {
  const ImplicitSurface cylinder{[](const Vec3& p) { return p.head<2>().squaredNorm() - 1; },
                                 [](const Vec3& p) { return Vec3(2 * p.x(), 2 * p.y(), 0); }};
  const ImplicitSurface plane{[](const Vec3& p) { return p.z(); },
                              [](const Vec3&) { return Vec3(0, 0, 1); }};
  for (const auto& [surface, direction] :
       {std::pair(cylinder, Vec3(0, 0, 1)), {plane, Vec3(1, 0, 0)}}) {
    try {
      (void)implicit_contour(surface, direction, {1, 0, 0});
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::infeasible_blend);
      EXPECT_NE(error.message().find("no direction at (1, 0, 0)"), std::string::npos);
    }
  }
}

TEST(RingedFitContour, ends_where_it_was_told) {
  const auto cylinder = ImplicitSurface{[](const Vec3& p) { return p[0] * p[0] + p[1] * p[1] - 1; },
                                        [](const Vec3& p) { return Vec3(2 * p[0], 2 * p[1], 0); }};
  const auto line =
      implicit_contour(cylinder, Vec3::UnitX(), {0.1, 1.1, 0}, {.step = 0.5, .most_points = 9});
  ASSERT_EQ(line.size(), 9);
  EXPECT_NEAR((line.back() - line.front()).norm(), 4, 1e-9);
  EXPECT_NEAR(line.back()[1], 1, 1e-9);
}

TEST(RingedFitContour, says_where_there_is_none) {
  const auto plane = test::by_differences([](const Vec3& p) { return p[2]; });
  EXPECT_THROW((void)implicit_contour(plane, Vec3(1, 0, 1), {0, 0, 1}), Error);
}

}  // namespace
}  // namespace dupin
