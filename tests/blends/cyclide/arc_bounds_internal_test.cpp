#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cyclide/arc_bounds.h"
#include "support/cyclide_cases.h"

namespace dupin {
namespace {

using std::numbers::pi;

// The surface in the frame that the symmetry plane carries along, by the fraction of the tangential
// length and the angle.
Vec3 point(const PeArc& arc, double fraction, double u) {
  const Ring circle = circle_at(arc, cyclide::parameter_at(arc, fraction));
  const Vec3 second = frame(arc).second, first = second.cross(circle.normal);
  return circle.center + circle.radius * (std::cos(u) * first + std::sin(u) * second);
}

// By central differences over the whole piece.
SecondDerivativeBounds measured(const PeArc& arc) {
  SecondDerivativeBounds sup;
  constexpr int kAlong = 60, kAround = 24;
  const double h = 1e-4;
  for (int i = 1; i < kAlong; ++i) {
    for (int j = 0; j < kAround; ++j) {
      const double s = double(i) / kAlong, u = 2 * pi * j / kAround;
      const auto x = [&](double ds, double du) { return point(arc, s + ds * h, u + du * h); };
      sup.along = std::max(sup.along, (x(1, 0) - 2 * x(0, 0) + x(-1, 0)).norm() / (h * h));
      sup.mixed =
          std::max(sup.mixed, (x(1, 1) - x(1, -1) - x(-1, 1) + x(-1, -1)).norm() / (4 * h * h));
    }
  }
  for (int i = 0; i <= kAlong; ++i) {
    const double t = cyclide::parameter_at(arc, double(i) / kAlong);
    sup.around = std::max(sup.around, circle_at(arc, t).radius);  // |x_uu|
  }
  return sup;
}

TEST(ArcBounds, hold_and_come_near_to_the_suprema) {
  test::RandomArcs arcs;
  for (int i = 0; i < 40; ++i) {
    const PeArc arc = arcs.next();
    const SecondDerivativeBounds sup = measured(arc);
    const cyclide::ArcConstants constants(arc);
    SecondDerivativeBounds bound;
    constexpr int kCells = 256;
    for (int cell = 0; cell < kCells; ++cell) {
      const auto here =
          cyclide::band_bounds(arc, constants, double(cell) / kCells, double(cell + 1) / kCells)
              .second;
      bound.along = std::max(bound.along, here.along);
      bound.mixed = std::max(bound.mixed, here.mixed);
      bound.around = std::max(bound.around, here.around);
    }
    // Differences with this step are good to about five digits.
    EXPECT_GE(bound.along, sup.along * (1 - 1e-4)) << i;
    EXPECT_GE(bound.mixed, sup.mixed * (1 - 1e-4)) << i;
    EXPECT_GE(bound.around, sup.around) << i;
    // The angle's worst case is taken term by term, which costs at most a factor.
    EXPECT_LE(bound.along, 2.5 * sup.along) << i;
    EXPECT_LE(bound.mixed, 1.2 * sup.mixed) << i;
    EXPECT_LE(bound.around, 1.05 * sup.around) << i;
  }
}

TEST(ArcBounds, stretches_hold_the_values_at_their_points) {
  test::RandomArcs arcs;
  for (int i = 0; i < 40; ++i) {
    const PeArc arc = arcs.next();
    const cyclide::ArcConstants constants(arc);
    for (int cell = 0; cell < 16; ++cell) {
      const double from = cyclide::parameter_at(arc, cell / 16.0);
      const double to = cyclide::parameter_at(arc, (cell + 1) / 16.0);
      const cyclide::ArcStretch range = cyclide::stretch(constants, from, to);
      for (int k = 0; k <= 8; ++k) {
        const double t = from + (to - from) * k / 8;
        const double slack = 1e-13 / (1 + arc.w());  // of the point, not of the interval
        const double r = sphere_at(arc, t).r, tau = tangent_at(arc, t).r;
        EXPECT_GE(r, range.radius.lower - slack);
        EXPECT_LE(r, range.radius.upper + slack);
        EXPECT_GE(tau, range.tau.lower - slack);
        EXPECT_LE(tau, range.tau.upper + slack);
      }
    }
  }
}

TEST(ArcBounds, fractions_measure_the_tangential_length) {
  test::RandomArcs arcs;
  for (int i = 0; i < 40; ++i) {
    const PeArc arc = arcs.next();
    const double t = cyclide::parameter_at(arc, 0.3);
    EXPECT_NEAR(pe_length(sub_arc(arc, 0, t)), 0.3 * pe_length(arc), 1e-9 * pe_length(arc));
    EXPECT_EQ(cyclide::parameter_at(arc, 1), 1);
  }
}

}  // namespace
}  // namespace dupin
