#include <cmath>

#include <gtest/gtest.h>

#include "dupin/blends/nurbs.h"

namespace dupin {
namespace {

/// A quarter of a cylinder about the z axis: a rational quadratic around, a line along.
NurbsSurface quarter(double radius, double height) {
  const double half = std::sqrt(0.5);
  const auto row = [&](double z) {
    return std::vector<std::array<double, 4>>{
        {radius, 0, z, 1}, {radius * half, radius * half, z * half, half}, {0, radius, z, 1}};
  };
  return {1, 2, {0, 0, 1, 1}, {0, 0, 0, 1, 1, 1}, {row(0), row(height)}};
}

TEST(NurbsSurface, of_a_cylinder_has_points_at_its_radius_and_height) {
  const NurbsSurface surface = quarter(3, 5);
  for (int i = 0; i <= 8; ++i) {
    for (int j = 0; j <= 8; ++j) {
      const Vec3 point = evaluate(surface, i / 8.0, j / 8.0);
      EXPECT_NEAR(point.head<2>().norm(), 3, 1e-15 * 8);
      EXPECT_NEAR(point.z(), 5 * i / 8.0, 1e-15 * 8);
    }
  }
  EXPECT_EQ(evaluate(surface, 0, 0), Vec3(3, 0, 0));
  EXPECT_EQ(evaluate(surface, 1, 1), Vec3(0, 3, 5));
}

TEST(NurbsCurve, of_a_ring_goes_round_it) {
  const Ring circle{{1, 2, 3}, Vec3(1, 2, 2) / 3, 5};
  const NurbsCurve curve = nurbs(circle);
  double turned = 0;
  for (int i = 0; i <= 40; ++i) {
    const Vec3 arm = evaluate(curve, i / 40.0) - circle.center;
    EXPECT_NEAR(arm.norm(), 5, 1e-14);
    EXPECT_NEAR(arm.dot(circle.normal), 0, 1e-14);
    const Vec3 next = evaluate(curve, (i + 1) / 41.0) - circle.center;
    turned += arm.cross(next).dot(circle.normal);
  }
  EXPECT_GT(turned, 0);
  EXPECT_EQ(evaluate(curve, 0), evaluate(curve, 1));
  Ring ellipse{{0, 0, 0}, Vec3::UnitZ(), 3};
  ellipse.ellipse = Ellipse{Vec3::UnitY(), 1, 0};
  const NurbsCurve oval = nurbs(ellipse);
  for (int i = 0; i <= 40; ++i) {
    const Vec3 p = evaluate(oval, i / 40.0);
    EXPECT_NEAR(p.x() * p.x() + p.y() * p.y() / 9, 1, 1e-14);
  }
}

// Cox and de Boor's recursion, term by term.
double basis(const std::vector<double>& knots, std::size_t i, int degree, double t) {
  if (degree == 0) {
    return knots[i] <= t && t < knots[i + 1] ? 1 : 0;
  }
  const auto p = std::size_t(degree);
  const auto share = [](double value, double width) { return width > 0 ? value / width : 0; };
  return share(t - knots[i], knots[i + p] - knots[i]) * basis(knots, i, degree - 1, t) +
         share(knots[i + p + 1] - t, knots[i + p + 1] - knots[i + 1]) *
             basis(knots, i + 1, degree - 1, t);
}

TEST(NurbsSurface, is_the_sum_of_weighted_points_by_its_basis_across_inner_knots) {
  NurbsSurface surface{3, 2, {0, 0, 0, 0, .25, .5, .5, 1, 1, 1, 1}, {0, 0, 0, .5, .5, 1, 1, 1}, {}};
  for (int i = 0; i < 7; ++i) {
    auto& row = surface.net.emplace_back();
    for (int j = 0; j < 5; ++j) {
      const double w = 1 + .25 * ((i + 2 * j) % 3);
      row.push_back({w * (i + .3 * j * j), w * (j - .2 * i), w * std::sin(i * j), w});
    }
  }
  for (const double along : {0.0, .1, .25, .4, .5, .75, .99}) {
    for (const double around : {0.0, .2, .5, .7, .95}) {
      Eigen::Array4d sum = Eigen::Array4d::Zero();
      for (std::size_t i = 0; i < surface.net.size(); ++i) {
        for (std::size_t j = 0; j < surface.net[i].size(); ++j) {
          sum += basis(surface.knots_along, i, 3, along) *
                 basis(surface.knots_around, j, 2, around) *
                 Eigen::Map<const Eigen::Array4d>(surface.net[i][j].data());
        }
      }
      const Vec3 expected = Vec3(sum[0], sum[1], sum[2]) / sum[3];
      EXPECT_NEAR((evaluate(surface, along, around) - expected).norm(), 0, 1e-14)
          << along << ' ' << around;
    }
  }
}

}  // namespace
}  // namespace dupin
