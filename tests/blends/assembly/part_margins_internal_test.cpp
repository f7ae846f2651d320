#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assembly/part_margins.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

// The quarter of a torus about the z axis that begins at the angle `from`, in quarters.
RingedSurface bend(double from, double radius, double bend_radius = 3) {
  const auto at = [&](double quarters) {
    const double angle = quarters * std::acos(0.0);
    return Vec3(std::cos(angle), std::sin(angle), 0);
  };
  const Vec3 start = bend_radius * at(from), end = bend_radius * at(from + 1);
  return {{start, -at(from + 1), radius},
          {end, at(from + 2), radius},
          ArcSpine{Vec3::Zero(), Vec3::UnitZ(), start, std::acos(0.0)},
          ConstantRadius{radius}};
}

TEST(PartMargins, of_a_torus_is_one_less_the_ratio_of_its_radii) {
  for (const double radius : {0.5, 1.0, 2.99}) {
    const PartMargins proven = margins(bend(0, radius), false);
    ASSERT_TRUE(proven.margin_lower && proven.margin_upper);
    const double exact = 1 - radius / 3;
    EXPECT_LE(*proven.margin_lower, exact);
    EXPECT_GE(*proven.margin_upper, exact);
    EXPECT_NEAR(*proven.margin_lower, exact, 1e-6);
    EXPECT_NEAR(*proven.margin_upper, exact, 1e-6);
    EXPECT_FALSE(proven.start_tangency || proven.end_tangency);
  }
}

TEST(PartMargins, of_a_chain_is_that_of_its_tightest_piece) {
  for (const std::size_t tight : {0U, 1U, 2U}) {
    std::vector<RingedSurface> pieces = {bend(0, 1), bend(1, 1), bend(2, 1)};
    pieces[tight] = bend(static_cast<double>(tight), 2);
    const PartMargins proven = margins(Chain(pieces), false);
    EXPECT_NEAR(proven.margin_lower.value(), 1.0 / 3, 1e-6);
    EXPECT_NEAR(proven.margin_upper.value(), 1.0 / 3, 1e-6);
  }
}

TEST(PartMargins, of_a_sphere_are_none) {
  const PartMargins none = margins(Sphere{Vec3::Zero(), 1}, true);
  EXPECT_FALSE(none.margin_lower || none.margin_upper || none.start_tangency || none.end_tangency);
}

TEST(PartMargins, refuses_folds) {
  const auto refusal = [](const PartSurface& surface) {
    try {
      (void)margins(surface, false);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::irregular_surface);
      return std::string(error.what());
    }
    return std::string("not refused");
  };
  constexpr const char* kFold =
      R"(the surface folds: the margin 1 - kappa R is (-0.[0-9]*) where it must be positive; use a smaller radius or a larger bend radius)";
  std::smatch margin;
  const std::string folded = refusal(bend(0, 4.5));
  ASSERT_TRUE(std::regex_match(folded, margin, std::regex(kFold))) << folded;
  EXPECT_NEAR(std::stod(margin[1]), -0.5, 1e-6);
  EXPECT_EQ(refusal(Chain(std::vector{bend(0, 1), bend(1, 4.5)})), folded);
  // Straight on and back again: its curvature is 0 wherever it has one.
  const RingedSurface turning{{Vec3::Zero(), Vec3(-1, 0, 0), 1},
                              {Vec3(1, 0, 0), Vec3(-1, 0, 0), 1},
                              BezierSpine{{Vec3::Zero(), Vec3(4, 0, 0), Vec3(1, 0, 0)}},
                              ConstantRadius{1}};
  EXPECT_EQ(refusal(turning),
            "the surface folds: its spine stops and turns round on the spot; choose other ends or "
            "points");
}

TEST(PartMargins, know_how_far_open_chains_are_from_tangent) {
  const PartMargins bent = margins(bend(0, 1), true);
  EXPECT_LT(bent.start_tangency.value(), 1e-14);
  EXPECT_LT(bent.end_tangency.value(), 1e-14);
  // A cylinder between rings that stand for cones of a half angle of 45 degrees and of 0.
  const RingedSurface kinked{{Vec3::Zero(), Vec3(0, 0, -1), 1, 1},
                             {Vec3(0, 0, 4), Vec3(0, 0, 1), 1},
                             LineSpine{Vec3::Zero(), Vec3(0, 0, 4)},
                             ConstantRadius{1}};
  const PartMargins off = margins(kinked, true);
  EXPECT_NEAR(off.start_tangency.value(), std::atan(1.0), 1e-9);
  EXPECT_LT(off.end_tangency.value(), 1e-14);
  const PartMargins closed =
      margins(Chain(std::vector{bend(0, 1), bend(1, 1), bend(2, 1), bend(3, 1)}, true), true);
  EXPECT_TRUE(closed.margin_lower);
  EXPECT_FALSE(closed.start_tangency || closed.end_tangency);
}

}  // namespace
}  // namespace dupin::assembly
