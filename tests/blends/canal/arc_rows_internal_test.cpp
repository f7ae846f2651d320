#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "canal/arc_rows.h"
#include "support/fillet_loops.h"

namespace dupin::canal {
namespace {

constexpr double kPi = std::numbers::pi;

// Control points as other code has them, and derivatives as differences of these.
TEST(ArcRows, are_the_control_points_of_arcs_and_their_derivatives) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    for (const double t : {-1.2, -0.3, 0.4, 1.1, 2.0, 2.9, 4.1}) {
      const ParameterInterval quarter{std::floor(2 * t / kPi) * kPi / 2,
                                      std::floor(2 * t / kPi + 1) * kPi / 2};
      const ArcRows rows = arc_rows(loop, {t, t}, quarter);
      const ContactArc arc = contact_arc(loop.quadrics, ball(loop, t));
      constexpr double kStep = 1e-4;
      const ContactArc before = contact_arc(loop.quadrics, ball(loop, t - kStep)),
                       after = contact_arc(loop.quadrics, ball(loop, t + kStep));
      const auto weight = [](const ContactArc& a) { return std::cos(a.angle / 2); };
      EXPECT_NEAR(middle(rows.weight.at[0]), weight(arc), 1e-11) << name;
      EXPECT_NEAR(middle(rows.weight.at[1]), (weight(after) - weight(before)) / (2 * kStep), 1e-5);
      EXPECT_NEAR(middle(rows.weight.at[2]),
                  (weight(after) - 2 * weight(arc) + weight(before)) / (2 * kStep * kStep), 1e-4)
          << name;
      for (int k = 0; k < 3; ++k) {
        const auto i = std::size_t(k);
        EXPECT_NEAR(middle(rows.points[0][i].at[0]), arc.feet[0][k], 1e-10) << name;
        EXPECT_NEAR(middle(rows.points[2][i].at[0]), arc.feet[1][k], 1e-10) << name;
        EXPECT_NEAR(middle(rows.points[1][i].at[0]), weight(arc) * arc.middle[k], 1e-10) << name;
        EXPECT_NEAR(middle(rows.points[0][i].at[1]),
                    (after.feet[0][k] - before.feet[0][k]) / (2 * kStep), 1e-5)
            << name;
      }
    }
  }
}

TEST(ArcRows, enclose_what_is_in_a_stretch) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    const ParameterInterval quarter{0, kPi / 2}, at{0.7, 0.72};
    const ArcRows over = arc_rows(loop, at, quarter);
    for (const double t : {0.7, 0.705, 0.713, 0.72}) {
      const ArcRows rows = arc_rows(loop, {t, t}, quarter);
      for (std::size_t order = 0; order < kArcOrders; ++order) {
        const double value = middle(rows.points[1][0].at.at(order));
        EXPECT_LE(over.points[1][0].at.at(order).lower, value) << name;
        EXPECT_GE(over.points[1][0].at.at(order).upper, value) << name;
      }
    }
  }
}

// sqrt, quotients and products undo each other, order by order.
TEST(Series, are_those_of_known_functions) {
  const Series<6> c = wave<6>(std::cos(0.7), -std::sin(0.7), 1),
                  s = wave<6>(std::sin(0.7), std::cos(0.7), 1);
  const Series<6> one = square(c) + s * s, root = square_root(Series<6>(2.0) + c),
                  back = square(root) - c, tangent = s / c;
  for (std::size_t k = 1; k < 6; ++k) {
    EXPECT_NEAR(middle(one.at.at(k)), 0, 1e-15);
    EXPECT_NEAR(middle(back.at.at(k)), 0, 1e-15);
  }
  EXPECT_NEAR(middle(tangent.at[1]), 1 / std::pow(std::cos(0.7), 2), 1e-14);
  EXPECT_NEAR(middle(derivative(tangent).at[0]), 1 / std::pow(std::cos(0.7), 2), 1e-14);
  EXPECT_EQ(shortened(s).at.size(), 5U);
  EXPECT_NEAR(middle(wave<4>(1, 0, 0.5).at[2]), -0.125, 1e-16);
}

}  // namespace
}  // namespace dupin::canal
