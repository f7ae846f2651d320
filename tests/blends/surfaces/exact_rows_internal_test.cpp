#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/paper_surfaces.h"
#include "surfaces/exact_rows.h"

namespace dupin::surfaces {
namespace {

// Whole steps along a line, on which other straight spines lie exactly.
const Vec3 kStep(2, -1, 2), kAlong = kStep / 3, kAxis = Vec3(1, 2, 0).normalized();
const LineSpine kLine{Vec3(1, 0, 1), Vec3(1, 0, 1) + 2 * kStep};

TEST(ExactRows, of_straight_spines_have_the_sections_of_every_parameter) {
  struct Row {
    Spine spine;
    RadiusLaw first, second;
    int degree;
  };
  const BezierSpine quadratic{{kLine.from, kLine.from + kStep / 2, kLine.to}};
  const HermiteSpine hermite{kLine.from, kLine.to, 1.5 * kStep, 6 * kStep};
  const Row rows[] = {
      {kLine, ConstantRadius{2}, ConstantRadius{.5}, 1},
      {kLine, LinearRadius{2, 1}, ConstantRadius{.5}, 1},
      {kLine, CubicRadius{2, 1}, LinearRadius{.5, 3}, 3},
      {hermite, LinearRadius{2, 1}, LinearRadius{1, 2}, 3},
      {quadratic, LinearRadius{2, 1}, ConstantRadius{1}, 2},
      {quadratic, BezierRadius{{1, 2, .5, 1, 3}}, CubicRadius{1, 2}, 4},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(&row - rows);
    const ExactRows found = exact_rows(row.spine, row.first, row.second, kAxis);
    ASSERT_EQ(found.degree, row.degree);
    const NurbsSurface surface = nurbs_through(found.rows, found.degree);
    const Vec3 across = kAlong.cross(kAxis);
    EXPECT_LT((evaluate(surface, 0, 0) - (kLine.from + dupin::evaluate(row.first, 0).value * kAxis))
                  .norm(),
              1e-14);
    for (const double t : {0., .1, .5, .7, 1.}) {
      const Vec3 center = dupin::evaluate(row.spine, t).position;
      for (int j = 0; j < 32; ++j) {
        const Vec3 d = evaluate(surface, t, j / 32.) - center;
        EXPECT_NEAR(d.dot(kAlong), 0, 1e-14);
        EXPECT_NEAR(std::hypot(d.dot(kAxis) / dupin::evaluate(row.first, t).value,
                               d.dot(across) / dupin::evaluate(row.second, t).value),
                    1, 1e-14);
      }
    }
  }
}

// The parameters differ, so that sections are compared at the angle where a point is.
TEST(ExactRows, of_arcs_have_the_turned_section_everywhere) {
  constexpr double kBend = 4, kFirst = 1.5, kSecond = .5;
  for (const double angle : {.3, std::numbers::pi / 2, 3.5, 6.}) {
    SCOPED_TRACE(angle);
    const ArcSpine arc{Vec3(1, 2, 3), Vec3::UnitZ(), Vec3(1 + kBend, 2, 3), angle};
    // At the start the arc runs along y, and the first semi-axis is tilted between x and z.
    const Vec3 first = Vec3(.6, 0, .8), second = Vec3::UnitY().cross(first);
    const ExactRows found = exact_rows(arc, ConstantRadius{kFirst}, ConstantRadius{kSecond}, first);
    ASSERT_EQ(found.degree, 2);
    const NurbsSurface surface = nurbs_through(found.rows, 2);
    double before = 0;
    for (int i = 0; i <= 30; ++i) {
      for (int j = 0; j < 30; ++j) {
        const Vec3 x = evaluate(surface, i / 30., j / 30.) - arc.center;
        double turned = std::atan2(x.y(), x.x());
        turned = turned < -1e-9 ? turned + 2 * std::numbers::pi : turned;
        EXPECT_GE(turned, before - 1e-12);
        before = turned;
        const Vec3 d(std::hypot(x.x(), x.y()) - kBend, 0, x.z());
        EXPECT_NEAR(std::hypot(d.dot(first) / kFirst, d.dot(second) / kSecond), 1, 1e-13);
      }
    }
    EXPECT_NEAR(before, angle, 1e-13);
    EXPECT_LT((evaluate(surface, 0, 0) - (arc.start + kFirst * first)).norm(), 1e-14);
  }
}

TEST(ExactRows, are_none_of_what_is_not_rational) {
  const ArcSpine arc{Vec3(0, 0, 0), Vec3::UnitZ(), Vec3(4, 0, 0), 1};
  const HermiteSpine nearly_straight{kLine.from, kLine.to, 1.5 * kStep + 1e-9 * kAxis, 6 * kStep};
  const BezierSpine weighted{{kLine.from, (kLine.from + kLine.to) / 2, kLine.to}, {1, 2, 1}};
  struct Row {
    Spine spine;
    RadiusLaw first, second;
  };
  const Row rows[] = {
      {kLine, CyclideRadius{1, 2}, ConstantRadius{1}},
      {kLine, ConstantRadius{1}, CyclideRadius{1, 2}},
      {arc, LinearRadius{1, 2}, ConstantRadius{1}},
      {arc, ConstantRadius{1}, CubicRadius{1, 2}},
      {test::skew_spine(10, 20), ConstantRadius{1}, ConstantRadius{1}},
      {nearly_straight, ConstantRadius{1}, ConstantRadius{1}},
      {weighted, ConstantRadius{1}, ConstantRadius{1}},
  };
  for (const Row& row : rows) {
    EXPECT_TRUE(exact_rows(row.spine, row.first, row.second, kAxis).rows.empty()) << &row - rows;
  }
}

}  // namespace
}  // namespace dupin::surfaces
