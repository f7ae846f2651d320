#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "surfaces/nurbs_rows.h"

namespace dupin::surfaces {
namespace {

// 0 on the row's ellipse, whose semi-axes are across each other, and in its plane.
double off_ellipse(const NurbsRow& row, const Vec3& point) {
  const Vec3 d = point - row.center / row.weight;
  const Vec3 a = row.a / row.weight, b = row.b / row.weight;
  return std::abs(std::hypot(d.dot(a) / a.squaredNorm(), d.dot(b) / b.squaredNorm()) - 1) +
         std::abs(d.dot(a.cross(b).normalized()));
}

TEST(NurbsRows, have_knots_of_joined_bezier_pieces) {
  using Knots = std::vector<double>;
  EXPECT_EQ(bezier_knots(1, 1), (Knots{0, 0, 1, 1}));
  EXPECT_EQ(bezier_knots(2, 4), (Knots{0, 0, 0, .25, .25, .5, .5, .75, .75, 1, 1, 1}));
  EXPECT_EQ(bezier_knots(3, 2), (Knots{0, 0, 0, 0, .5, .5, .5, 1, 1, 1, 1}));
}

TEST(NurbsRows, are_ellipses) {
  const Vec3 center(1, 2, 3), a(0, 2, 0), b(.6, 0, .8);
  for (const double weight : {1., 0.25}) {
    const NurbsRow row{weight * center, weight * a, weight * b, weight};
    const NurbsSurface flat = nurbs_through({row, row}, 1);
    for (const double t : {0., 0.3, 1.}) {
      for (int j = 0; j <= 40; ++j) {
        EXPECT_NEAR(off_ellipse(row, evaluate(flat, t, j / 40.)), 0, 1e-14);
      }
      EXPECT_LT((evaluate(flat, t, 0) - (center + a)).norm(), 1e-15);
      EXPECT_LT((evaluate(flat, t, .25) - (center + b)).norm(), 1e-15);
      EXPECT_LT((evaluate(flat, t, 1) - evaluate(flat, t, 0)).norm(), 1e-15);
    }
  }
}

// Two rational pieces that turn by a right angle each: half a torus about the y axis.
TEST(NurbsRows, are_joined_into_pieces_that_share_them) {
  constexpr double kBend = 3;
  std::vector<NurbsRow> rows;
  for (int i = 0; i <= 4; ++i) {
    const double angle = i * std::numbers::pi / 4, weight = i % 2 == 0 ? 1 : std::sqrt(.5);
    // The middle row lies where the tangents meet: its homogeneous points are turned, not scaled.
    const Vec3 out(std::cos(angle), 0, std::sin(angle));
    rows.push_back({kBend * out, out, weight * Vec3::UnitY(), weight});
  }
  const NurbsSurface surface = nurbs_through(rows, 2);
  EXPECT_EQ(surface.knots_along.size(), rows.size() + 3);
  EXPECT_EQ(surface.net.size(), rows.size());
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      const Vec3 x = evaluate(surface, i / 20., j / 20.);
      EXPECT_NEAR(std::hypot(std::hypot(x.x(), x.z()) - kBend, x.y()), 1, 1e-14);
      EXPECT_GE(x.z(), -1e-15);
    }
  }
  for (const std::size_t k : {0U, 1U, 2U}) {
    EXPECT_NEAR(off_ellipse(rows[2 * k], evaluate(surface, double(k) / 2, 0.1)), 0, 1e-14);
  }
}

}  // namespace
}  // namespace dupin::surfaces
