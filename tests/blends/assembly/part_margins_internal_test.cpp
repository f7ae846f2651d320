#include <cmath>
#include <numbers>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "assembly/part_margins.h"
#include "dupin/blends/build.h"
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
    const PartMargins proven = margins(bend(0, radius), false, "elbow");
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
    const PartMargins proven = margins(Chain(pieces), false, "spline");
    EXPECT_NEAR(proven.margin_lower.value(), 1.0 / 3, 1e-6);
    EXPECT_NEAR(proven.margin_upper.value(), 1.0 / 3, 1e-6);
  }
}

TEST(PartMargins, of_a_sphere_are_none) {
  const PartMargins none = margins(Sphere{Vec3::Zero(), 1}, true, "sphere");
  EXPECT_FALSE(none.margin_lower || none.margin_upper || none.start_tangency || none.end_tangency);
}

TEST(PartMargins, refuses_folds) {
  const auto refusal = [](const PartSurface& surface) {
    try {
      (void)margins(surface, false, "elbow");
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::irregular_surface);
      return std::string(error.what());
    }
    return std::string("not refused");
  };
  constexpr const char* kFold =
      R"(the surface folds: the margin 1 - kappa R is at most (-0.[0-9]{1,6}) where it must be positive; use a smaller radius or a larger bend radius)";
  std::smatch margin;
  const std::string folded = refusal(bend(0, 4.5));
  ASSERT_TRUE(std::regex_match(folded, margin, std::regex(kFold))) << folded;
  EXPECT_EQ(margin[1], "-0.499999");  // a bound of -0.5
  EXPECT_EQ(refusal(Chain(std::vector{bend(0, 1), bend(1, 4.5)})), folded);
  // Straight on and back again: its curvature is 0 wherever it has one.
  const RingedSurface turning{{Vec3::Zero(), Vec3(-1, 0, 0), 1},
                              {Vec3(1, 0, 0), Vec3(-1, 0, 0), 1},
                              BezierSpine{{Vec3::Zero(), Vec3(4, 0, 0), Vec3(1, 0, 0)}},
                              ConstantRadius{1}};
  EXPECT_EQ(refusal(turning),
            "the surface may fold: its spine stops, or is not known to go on, where it may turn "
            "round on the spot; choose other ends or points");
}

// Only an elbow has a bend radius.
TEST(PartMargins, refuses_folds_with_what_parts_of_the_kind_have) {
  const auto remedy = [](std::string_view kind) {
    try {
      (void)margins(bend(0, 4.5), false, kind);
    } catch (const Error& error) {
      return error.message().substr(error.message().rfind("; "));
    }
    return std::string();
  };
  EXPECT_EQ(remedy("two_cone_blend"), "; smaller radii, another reach or other weights may do");
  EXPECT_EQ(remedy("cyclic_blend"), "; smaller radii or other lengths k and l may do");
  EXPECT_EQ(remedy("ringed_blend"), "; smaller radii or other lengths k and l may do");
  EXPECT_EQ(remedy("spline"), "; smaller radii or points further apart may do");
  EXPECT_EQ(remedy("cyclide_chain"), "; smaller radii may do");
}

// As it is told, with another reach or radii, it builds.
TEST(PartMargins, of_a_two_cone_blend_are_those_that_its_reach_decides) {
  const auto refusal = [](double reach, double radius) {
    const Assembly document{
        "d.json",
        Unit::millimetre,
        0.1,
        {},
        {{"a", PipeBetween{{-20, 0, 0}, {0, 0, 0}, radius}},
         {"b", PipeBetween{{8, 8, 0}, {8, 28, 0}, radius}},
         {"t", TwoConeBlendBetween{{"a", End::end}, {"b", End::start}, {reach, reach}}}}};
    try {
      (void)build(document);
    } catch (const Error& error) {
      return error.message();
    }
    return std::string();
  };
  EXPECT_TRUE(refusal(7.5, 3).ends_with("; smaller radii, another reach or other weights may do"));
  EXPECT_EQ(refusal(4, 3), "");
  EXPECT_EQ(refusal(7.5, 1), "");
}

// In doubles the two are the same: no bound is positive, none is negative.
TEST(PartMargins, call_a_fold_undecided_that_is_not_proved) {
  try {
    (void)margins(bend(0, 3), false, "elbow");
    FAIL();
  } catch (const Error& error) {
    EXPECT_TRUE(std::regex_search(
        error.message(), std::regex("whether the surface folds is undecided: .* is proved only "
                                    "that it is at least -[0-9.]+e-1[0-9] and at most ")))
        << error.message();
  }
}

// The last one's margin is no double that bounds would show: the two radii are compared exactly.
TEST(PartMargins, of_bends_barely_wider_than_the_pipe_are_proved) {
  for (const double radius : {1 - 1e-5, 1 - 1e-9, 1 - 1e-13, std::nextafter(1.0, 0.0)}) {
    const RingedSurface torus{{Vec3(1, 0, 0), Vec3(0, -1, 0), radius},
                              {Vec3(0, 1, 0), Vec3(-1, 0, 0), radius},
                              ArcSpine{Vec3::Zero(), Vec3::UnitZ(), Vec3(1, 0, 0), std::acos(0.0)},
                              ConstantRadius{radius}};
    EXPECT_NO_THROW((void)margins(torus, false, "elbow")) << 1 - radius;
  }
}

TEST(PartMargins, meshes_that_are_no_solids_refute_no_surface) {
  const auto refusal = [](const PartSurface& surface) {
    try {
      refuse_mesh(surface,
                  Error(Errc::self_intersecting, "faces 1 and 2 intersect; unite others instead"));
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::irregular_surface);
      EXPECT_EQ(error.message().find("the part's mesh is no solid: faces 1 and 2 intersect; "), 0U);
      return error.message();
    }
  };
  EXPECT_NE(refusal(bend(0, 1)).find("the surface does not cross itself"), std::string::npos);
  EXPECT_EQ(refusal(bend(0, 1)).find("unite others"), std::string::npos);
  EXPECT_TRUE(refusal(Chain(CyclidePiece{})).ends_with("or other spheres or tangents"));
  const auto torus = [](double angle, double radius) {
    return RingedSurface{{},
                         {},
                         ArcSpine{Vec3::Zero(), Vec3::UnitZ(), Vec3(1, 0, 0), angle},
                         ConstantRadius{radius}};
  };
  EXPECT_NE(refusal(torus(1, 1 - 1e-9)).find("within 1e-09 of its axis, too near for these coord"),
            std::string::npos);
  EXPECT_NE(refusal(torus(5, 1 - 1e-9)).find("within 1e-09 of its axis, too near for these coord"),
            std::string::npos);
  EXPECT_NE(refusal(torus(2 * std::numbers::pi - 1e-6, .5))
                .find("its ends come within 5.00001e-07 of each other, too near for these coord"),
            std::string::npos);
  EXPECT_NE(refusal(bend(0, 3)).find("is undecided"), std::string::npos);
  EXPECT_NE(refusal(Chain(std::vector{bend(0, 1), bend(1, 1)})).find("is undecided"),
            std::string::npos);
}

TEST(PartMargins, know_how_far_open_chains_are_from_tangent) {
  const PartMargins bent = margins(bend(0, 1), true, "elbow");
  EXPECT_LT(bent.start_tangency.value(), 1e-14);
  EXPECT_LT(bent.end_tangency.value(), 1e-14);
  // A cylinder between rings that stand for cones of a half angle of 45 degrees and of 0.
  const RingedSurface kinked{{Vec3::Zero(), Vec3(0, 0, -1), 1, 1},
                             {Vec3(0, 0, 4), Vec3(0, 0, 1), 1},
                             LineSpine{Vec3::Zero(), Vec3(0, 0, 4)},
                             ConstantRadius{1}};
  const PartMargins off = margins(kinked, true, "spline");
  EXPECT_NEAR(off.start_tangency.value(), std::atan(1.0), 1e-9);
  EXPECT_LT(off.end_tangency.value(), 1e-14);
  const PartMargins closed = margins(
      Chain(std::vector{bend(0, 1), bend(1, 1), bend(2, 1), bend(3, 1)}, true), true, "spline");
  EXPECT_TRUE(closed.margin_lower);
  EXPECT_FALSE(closed.start_tangency || closed.end_tangency);
}

}  // namespace
}  // namespace dupin::assembly
