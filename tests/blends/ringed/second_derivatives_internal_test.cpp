#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/ringed/ringed_blends.h"
#include "dupin/blends/spine.h"
#include "dupin/kernel/error.h"
#include "ringed/second_derivatives.h"
#include "support/paper_surfaces.h"

namespace dupin::ringed {
namespace {

using std::numbers::pi;

const BezierSpine kRational{{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(3, 1, 0), Vec3(3, 3, 1)},
                            {1, 2, .5, 1}};

using Point = std::function<Vec3(double t, double u)>;

// The largest second differences over a grid of the stretch.
SecondDerivativeBounds sampled(const Point& x, double from, double to) {
  SecondDerivativeBounds most;
  const double h = 1e-4;
  for (int i = 0; i <= 8; ++i) {
    const double t = std::clamp(std::lerp(from, to, i / 8.), h, 1 - h);
    for (int j = 0; j < 24; ++j) {
      const double u = 2 * pi * j / 24;
      const Vec3 tt = (x(t + h, u) - 2 * x(t, u) + x(t - h, u)) / (h * h);
      const Vec3 tu =
          (x(t + h, u + h) - x(t + h, u - h) - x(t - h, u + h) + x(t - h, u - h)) / (4 * h * h);
      const Vec3 uu = (x(t, u + h) - 2 * x(t, u) + x(t, u - h)) / (h * h);
      most = {std::max(most.along, tt.norm()), std::max(most.mixed, tu.norm()),
              std::max(most.around, uu.norm())};
    }
  }
  return most;
}

// The bounds hold, and those of one place are at most `most` times too large.
template <class Surface>
void expect_bounds(const Surface& surface, const Point& x, double most) {
  for (const double from : {0., .375, .9375}) {
    const double to = from + .0625;
    SecondDerivativeBounds found = band_bounds(surface, from, to).second,
                           sup = sampled(x, from, to);
    EXPECT_GE(found.along, sup.along - 1e-3);
    EXPECT_GE(found.mixed, sup.mixed - 1e-3);
    EXPECT_GE(found.around, sup.around - 1e-3);
    found = band_bounds(surface, to, to).second;
    sup = sampled(x, to, to);
    EXPECT_LE(found.along, most * sup.along);
    EXPECT_LE(found.mixed, most * sup.mixed + 1e-3);
    EXPECT_LE(found.around, 1.01 * sup.around);
  }
}

TEST(BandBounds, of_ringed_surfaces_hold_at_samples) {
  for (const RingedSurface& surface :
       {test::figure6(), test::figure6(CyclideRadius{1, 2}),
        RingedSurface{{}, {}, kRational, BezierRadius{{.5, .7, .3}}},
        RingedSurface{{},
                      {},
                      ArcSpine{Vec3(0, 0, 0), Vec3::UnitZ(), Vec3(4, 0, 0), 1.5},
                      LinearRadius{1, 2}}}) {
    const FrameField frames(surface.spine, Vec3(.3, .5, .9), {.knots = 4096});
    expect_bounds(
        surface, [&](double t, double u) { return evaluate(surface, frames, t, u).position; }, 2);
  }
}

TEST(BandBounds, of_elliptic_tubes_hold_while_the_axes_turn) {
  for (const Continuity continuity : {Continuity::g1, Continuity::g2}) {
    EllipticTube tube;
    tube.spine = test::skew_spine(10, 20);
    tube.first = CubicRadius{1, .5};
    tube.second = LinearRadius{.5, .75};
    tube.axis = Vec3::UnitY();
    tube.turn = 1.25;
    tube.continuity = continuity;
    const FrameField field = frames(tube, {.knots = 4096});
    expect_bounds(
        tube, [&](double t, double u) { return evaluate(tube, field, t, u).position; }, 5);
  }
}

TEST(BandBounds, of_rational_ringed_surfaces_hold_in_their_frame) {
  for (const RationalRingedSurface& surface :
       {test::cone_to_cylinder(), test::general_ends(),
        canal_ringed_blend(test::start_cone(), test::end_cone())}) {
    expect_bounds(
        surface, [&](double t, double v) { return evaluate(surface, t, v).position; }, 4);
    EXPECT_EQ(band_bounds(surface, 0, 1).turning, 0);
  }
}

TEST(BandBounds, of_cells_are_those_of_each) {
  constexpr std::uint32_t kCells = 8;
  RingedSurface flat;  // in a plane: what is 0 stays so
  flat.spine = HermiteSpine{{0, 0, 0}, {9, 4, 0}, {6, 0, 0}, {5, 6, 0}};
  flat.radius = ConstantRadius{0.5};
  const auto cells = band_bounds_of_cells(flat, kCells);
  ASSERT_EQ(cells.size(), kCells);
  for (std::uint32_t i = 0; i < kCells; ++i) {
    const BandBounds own = band_bounds(flat, double(i) / kCells, double(i + 1) / kCells);
    EXPECT_EQ(cells[i].second.along, own.second.along);
    EXPECT_EQ(cells[i].second.mixed, own.second.mixed);
    EXPECT_EQ(cells[i].turning, own.turning);
  }
}

TEST(SpineBounds, hold_the_speed_and_the_turning) {
  for (const Spine& spine :
       {Spine(test::skew_spine(10, 20)), Spine(kRational), Spine(LineSpine{{0, 0, 0}, {3, 4, 0}}),
        Spine(ArcSpine{Vec3(0, 0, 0), Vec3::UnitZ(), Vec3(4, 0, 0), 1.5})}) {
    for (const double from : {0., .5}) {
      const SpineBounds found = spine_bounds(spine, {from, from + .125});
      for (int i = 0; i <= 8; ++i) {
        const SpinePoint y = evaluate(spine, from + i / 64.);
        const double v = y.first.norm();
        EXPECT_LE(found.speed.lower, v * (1 + 1e-14));
        EXPECT_GE(found.speed.upper, v * (1 - 1e-14));
        EXPECT_GE(found.turning, curvature(y) * v * (1 - 1e-14));
        EXPECT_GE(found.acceleration, std::abs(y.first.dot(y.second)) / v - 1e-12);
        // T'' across T, by differences of T' = (y'' - (y''.T) T) / v.
        const double h = 1e-5;
        const auto rate = [&](double t) -> Vec3 {
          const SpinePoint z = evaluate(spine, t);
          const Vec3 tangent = z.first.normalized();
          return (z.second - z.second.dot(tangent) * tangent) / z.first.norm();
        };
        const double t = from + i / 64.;
        const Vec3 change = (rate(t + h) - rate(t - h)) / (2 * h), along = y.first.normalized();
        EXPECT_GE(found.turning_change, (change - change.dot(along) * along).norm() - 1e-5);
      }
    }
  }
}

TEST(RadiusBounds, hold_the_radius_and_its_derivatives) {
  for (const RadiusLaw& law :
       {RadiusLaw(ConstantRadius{2}), RadiusLaw(LinearRadius{2, 1}), RadiusLaw(CubicRadius{1, 3}),
        RadiusLaw(CyclideRadius{1, 3}), RadiusLaw(CyclideRadius{3, .1}),
        RadiusLaw(BezierRadius{{1, .5, 2, 1}})}) {
    for (double from = 0; from < 1; from += .125) {
      const RadiusBounds found = radius_bounds(law, {from, from + .125});
      RadiusBounds most;
      for (int i = 0; i <= 8; ++i) {
        const RadiusValue r = evaluate(law, from + i / 64.);
        most = {std::max(most.value, r.value), std::max(most.first, std::abs(r.first)),
                std::max(most.second, std::abs(r.second))};
      }
      EXPECT_GE(found.value, most.value * (1 - 1e-14));
      EXPECT_GE(found.first, most.first * (1 - 1e-12) - 1e-13);
      EXPECT_GE(found.second, most.second * (1 - 1e-12) - 1e-12);
      EXPECT_LE(found.value, 1.5 * most.value);
    }
  }
}

TEST(BandBounds, refuse_spines_that_stop_and_ranges_that_are_none) {
  const RingedSurface stops{
      {}, {}, BezierSpine{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 0)}}, ConstantRadius{1}};
  EXPECT_THROW((void)band_bounds(stops, .25, .75), Error);
  EXPECT_NO_THROW((void)band_bounds(stops, 0, .25));
  for (const auto& [from, to] : {std::pair(-.1, .5), {.5, 1.1}, {.5, .25}}) {
    EXPECT_THROW((void)second_derivative_bounds(test::figure6(), from, to), Error);
  }
}

TEST(BezierSpine, second_derivative_bounds_contain_samples) {
  const RingedSurface surface{
      {},
      {},
      two_cone_spine({Vec3(4, 0, 0), Vec3(4, 4, 0), Vec3(0, 4, 0), Vec3(0, 6, 5)}, {1, 1, 1},
                     {1, 2, 1}),
      BezierRadius{{1, 1.2, .7, .8}}};
  for (const double from : {0., .3, .8}) {
    const double to = from + .05;
    const SecondDerivativeBounds bounds = second_derivative_bounds(surface, from, to);
    const FrameField frames(surface.spine, Vec3::UnitX());
    const double h = 1e-4;
    for (double t = from + h; t < to - h; t += .01) {
      for (double u = 0; u < 6; u += .7) {
        const auto x = [&](double s) { return evaluate(surface, frames, s, u).position; };
        const double along = ((x(t + h) - 2 * x(t) + x(t - h)) / (h * h)).norm();
        EXPECT_LE(along, bounds.along + 1e-3);
      }
    }
  }
}

}  // namespace
}  // namespace dupin::ringed
