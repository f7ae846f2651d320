#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/nurbs.h"
#include "dupin/kernel/error.h"
#include "support/fillet_loops.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

// How far a point is from the envelope of the balls, by the nearest of many arcs.
double distance(const CanalFillet& loop, const Vec3& p, double about) {
  double best = 1e9, step = 0.05;
  const auto off = [&](double chi) {
    const MovingBall at = ball(loop, chi);
    return std::abs((p - at.center).norm() - at.radius);
  };
  // Of all balls near there it is furthest inside one, or nearest to it.
  const auto depth = [&](double chi) {
    const MovingBall at = ball(loop, chi);
    return (p - at.center).norm() - at.radius;
  };
  for (; step > 1e-9; step /= 2) {
    if (depth(about + step) < depth(about)) {
      about += step;
    } else if (depth(about - step) < depth(about)) {
      about -= step;
    }
    best = off(about);
  }
  return best;
}

TEST(NurbsOfFillet, keeps_to_the_tolerance_and_to_the_feet) {
  for (const double tolerance : {1e-2, 1e-5}) {
    for (const auto& [name, loop] : test::loops_of_all_kinds()) {
      const NurbsForm form = nurbs(loop, tolerance);
      EXPECT_GT(form.error_bound, 0) << name;
      EXPECT_LE(form.error_bound, tolerance) << name;
      EXPECT_EQ(form.surfaces.size(), std::max<std::size_t>(corners(loop).size(), 1)) << name;
      double begin = corners(loop).empty() ? -kPi / 2 : corners(loop).front();
      for (const NurbsSurface& surface : form.surfaces) {
        const double length = 2 * kPi / double(form.surfaces.size());
        for (int i = 0; i <= 100; ++i) {
          const double along = (i + 0.3) / 100.6, chi = begin + along * length;
          const MovingBall at = ball(loop, chi);
          const ContactArc arc = contact_arc(loop.quadrics, at);
          EXPECT_LT((evaluate(surface, along, 0) - arc.feet[0]).norm(), tolerance) << name;
          EXPECT_LT((evaluate(surface, along, 1) - arc.feet[1]).norm(), tolerance) << name;
          EXPECT_LT((evaluate(surface, along, 0.5) - point(arc, arc.angle / 2)).norm(), tolerance)
              << name;
          EXPECT_LT(distance(loop, evaluate(surface, along, 0.3), chi), tolerance) << name;
        }
        begin += length;
      }
    }
  }
}

// It is tangent to the quadrics along the feet, the better the finer it is.
TEST(NurbsOfFillet, is_tangent_to_the_pipes) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    double last = 1;
    for (const double tolerance : {1e-2, 1e-5}) {
      const NurbsSurface surface = nurbs(loop, tolerance).surfaces.front();
      double worst = 0;
      for (int i = 0; i < 50; ++i) {
        const double t = (i + 0.5) / 50, h = 1e-6;
        for (const double u : {0.0, 1.0}) {
          const double in = u == 0 ? h : 1 - h;
          const Vec3 p = evaluate(surface, t, u);
          const Vec3 along = evaluate(surface, t + h, u) - evaluate(surface, t - h, u);
          const Vec3 across = evaluate(surface, t, in) - p;
          if (across.norm() < 1e-9) {
            continue;  // near a corner
          }
          const Ring& quadric = loop.quadrics[u == 0 ? 0 : 1];
          const Vec3 from = p - quadric.center;
          const Vec3 arm = (from - from.dot(quadric.normal) * quadric.normal).normalized();
          const Vec3 normal = (arm - quadric.slope * quadric.normal).normalized();
          worst = std::max(worst, std::abs(along.cross(across).normalized().cross(normal).norm()));
        }
      }
      constexpr double kOfDifferences = 2e-6;
      EXPECT_LT(worst, std::max(0.2 * last, kOfDifferences)) << name << ' ' << tolerance;
      last = worst;
    }
    EXPECT_LT(last, 5e-3) << name;
  }
}

TEST(NurbsOfFillet, is_exact_where_the_fillet_is_rational) {
  const auto loop =
      rational_fillet({Ring{{0, 0, 0}, {1, 0, 0}, 4, 0}, Ring{{0, 0, 0}, {0, 1, 0}, 2, 0}},
                      {1, 0.448979591836735, 1, 0.448979591836735}, 1);
  const auto constant = [&] {
    CanalFillet result = loop;
    std::get<RationalCrossing>(result.motion).size = {0.3, 0, 0, 0};
    return result;
  }();
  const NurbsForm form = nurbs(constant, 1e-3);
  ASSERT_EQ(form.surfaces.size(), 4U);
  EXPECT_EQ(form.error_bound, 0);
  EXPECT_EQ(form.surfaces[0].degree_along, 10);
  for (const NurbsSurface& surface : form.surfaces) {
    for (const double t : {0.0, 0.3, 1.0}) {
      for (const double u : {0.0, 0.5, 1.0}) {
        const Vec3 p = evaluate(surface, t, u);
        double best = 1;
        for (int i = 0; i < 4000; ++i) {
          const MovingBall at = ball(constant, 2 * kPi * i / 4000);
          best = std::min(best, std::abs((p - at.center).norm() - at.radius));
        }
        EXPECT_LT(best, 1e-5);
      }
    }
  }
}

// So many cubics as an error of h^4 / 384 asks for, and not many more.
TEST(NurbsOfFillet, takes_few_cubics) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    std::size_t cubics = 0;
    for (const NurbsSurface& surface : nurbs(loop, 1e-3).surfaces) {
      cubics += surface.net.size() / 2 - 1;
    }
    EXPECT_LE(cubics, 200U) << name;
  }
}

TEST(NurbsOfFillet, refuses_tolerances_that_take_too_much) {
  EXPECT_THROW((void)nurbs(test::loops_of_all_kinds().front().loop, 1e-18), Error);
}

}  // namespace
}  // namespace dupin
