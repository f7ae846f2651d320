#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "assembly/parts/line_and_arc.h"
#include "dupin/blends/cyclic_blend.h"
#include "dupin/blends/rational_ringed_surface.h"
#include "surfaces/least_wall.h"

namespace dupin::surfaces {
namespace {

constexpr double kPi = std::numbers::pi;

// The least distance of two ellipses, by samples: no less than the truth by much.
double sampled(double a, double b, double wall) {
  double least = std::numeric_limits<double>::infinity();
  const auto at = [](double x, double y, int i) {
    return Vec3(x * std::cos(i * kPi / 800), y * std::sin(i * kPi / 800), 0);
  };
  for (int i = 0; i <= 400; ++i) {
    for (int k = 0; k <= 400; ++k) {
      least = std::min(least, (at(a, b, i) - at(a - wall, b - wall, k)).norm());
    }
  }
  return least;
}

TEST(LeastWall, across_ellipses_is_a_tight_lower_bound) {
  for (const auto& [a, b, wall] : {std::array{2.0, 1.0, 0.1},
                                   {1.0, 2.0, 0.3},
                                   {5.0, 1.0, 0.2},
                                   {1.0, 1.0, 0.25},
                                   {3.0, 2.9, 1.0}}) {
    const double bound = ellipse_wall(a, b, wall), true_wall = sampled(a, b, wall);
    EXPECT_LE(bound, true_wall) << a << ' ' << b;
    EXPECT_GT(bound, true_wall * 0.99) << a << ' ' << b;
  }
  // What docs/assembly_format.md says of axes of 2 to 1.
  EXPECT_GT(ellipse_wall(2, 1, 0.01), 0.94 * 0.01);
  EXPECT_LT(ellipse_wall(2, 1, 0.01), 0.95 * 0.01);
}

TEST(LeastWall, of_pipes_and_bends_is_the_wall_and_of_cones_its_cosine) {
  const Ring start{{0, 0, 0}, {0, 0, -1}, 2};
  EXPECT_NEAR(*least_wall(assembly::cylinder(start, {0, 0, 9}), 0.5), 0.5, 1e-13);
  EXPECT_NEAR(*least_wall(assembly::line(start, {0, 0, 4}, {5, {}}, true), 0.5), 0.5 * 4 / 5,
              1e-12);
  EXPECT_NEAR(
      *least_wall(assembly::arc(start, {{3, 0, 3}, {1, 0, 0}, 2}, {1, 0, 0}, 3, kPi / 2), 0.5), 0.5,
      1e-13);
  EXPECT_EQ(*least_wall(Sphere{{1, 2, 3}, 2}, 0.5), 0.5);
  EXPECT_FALSE(least_wall(oblique_tube({0, 0, 0}, {1, 0, 4}, {0, 0, 1}, 2, 2), 0.5));
}

// Distances of points on the bore from the surface, by dense samples of both in one plane.
TEST(LeastWall, of_blends_holds_for_samples_of_both_surfaces) {
  const RingedSurface blend =
      cyclic_blend({{0, 0, 0}, {1, 0, 0}, 1}, {{6, 4, 0}, {0, -1, 0}, 2}, {.k = 8, .l = 8});
  const double wall = 0.3;
  const double bound = *least_wall(blend, wall);
  EXPECT_GT(bound, 0.2 * wall);
  const auto side = [&](double t, double sign, double inwards) {
    const SpinePoint y = evaluate(blend.spine, t);
    const Vec3 across(-y.first.y(), y.first.x(), 0);
    return Vec3(y.position +
                sign * (evaluate(blend.radius, t).value - inwards) * across.normalized());
  };
  for (const double sign : {-1.0, 1.0}) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 20; i <= 180; ++i) {
      for (int k = 0; k <= 2000; ++k) {
        least = std::min(least, (side(i / 200., sign, wall) - side(k / 2000., sign, 0)).norm());
      }
    }
    EXPECT_GE(least, bound);
  }
}

}  // namespace
}  // namespace dupin::surfaces
