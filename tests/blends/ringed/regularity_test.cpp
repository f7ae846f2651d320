#include "dupin/blends/regularity.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/paper_surfaces.h"

namespace dupin {
namespace {

const CubicRadius kCubic{1, 2};
const CyclideRadius kCyclide{1, 2};

struct MarginRow {
  RingedSurface surface;
  double margin, at;
};

class Margin : public testing::TestWithParam<MarginRow> {};

TEST_P(Margin, lies_between_its_certified_bounds) {
  const MarginRow row = GetParam();
  for (const double width : {1e-3, 1e-6, 1e-11}) {
    const Regularity r = regularity(row.surface, {width});
    EXPECT_LE(r.lower, row.margin + 1e-11);
    EXPECT_GE(r.upper, row.margin - 1e-11);
    EXPECT_LE(r.upper - r.lower, width * std::max(1.0, 1 - row.margin) * 1.001);
    EXPECT_LE(r.minimum.from, row.at);
    EXPECT_GE(r.minimum.to, row.at);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Figures5And6, Margin,
    testing::Values(MarginRow{test::figure5(kCubic), -0.319643125931, 0.7238703750},
                    MarginRow{test::figure6(kCubic), 0.0848584660472, 0.7866177558},
                    MarginRow{test::figure5(kCyclide), -0.291176674162, 0.7249855495},
                    MarginRow{test::figure6(kCyclide), 0.0962221823638, 0.788051308}));

TEST(Regularity, finds_where_figure_5_folds) {
  const Regularity cubic = regularity(test::figure5(kCubic));
  ASSERT_EQ(cubic.folded.size(), 1u);
  EXPECT_NEAR(cubic.folded[0].from, 0.659510100362, 6e-13);
  EXPECT_NEAR(cubic.folded[0].to, 0.787707736547, 6e-13);
  const Regularity cyclide = regularity(test::figure5(kCyclide));
  ASSERT_EQ(cyclide.folded.size(), 1u);
  EXPECT_NEAR(cyclide.folded[0].from, 0.663701719693, 6e-13);
  EXPECT_NEAR(cyclide.folded[0].to, 0.786117649704, 6e-13);
}

TEST(Regularity, finds_no_fold_in_figure_6) {
  EXPECT_TRUE(regularity(test::figure6(kCubic)).folded.empty());
  EXPECT_TRUE(regularity(test::figure6(kCyclide)).folded.empty());
}

TEST(Regularity, of_the_u_bend_has_the_tabulated_margins) {
  const Regularity cubic = regularity(test::u_bend(CubicRadius{2, 4}), {1e-10});
  EXPECT_NEAR(cubic.lower, .426650118, 6e-10);
  EXPECT_NEAR(cubic.upper, .426650118, 6e-10);
  const Regularity cyclide = regularity(test::u_bend(CyclideRadius{2, 4}), {1e-10});
  EXPECT_NEAR(cyclide.lower, .430823842, 6e-10);
  EXPECT_NEAR(cyclide.upper, .430823842, 6e-10);
}

struct ProofRow {
  double margin;
  Verdict verdict;
  std::size_t leaves;
  int depth;
};

class Figure6Proof : public testing::TestWithParam<ProofRow> {};

TEST_P(Figure6Proof, takes_the_tabulated_subdivision) {
  const ProofRow row = GetParam();
  const MarginProof proof = prove_margin(test::figure6(kCubic), row.margin);
  EXPECT_EQ(proof.verdict, row.verdict);
  if (row.verdict == Verdict::proved) {
    EXPECT_EQ(proof.leaves, row.leaves);
    EXPECT_EQ(proof.depth, row.depth);
  }
}

INSTANTIATE_TEST_SUITE_P(Margins, Figure6Proof,
                         testing::Values(ProofRow{0, Verdict::proved, 3, 2},
                                         ProofRow{.08, Verdict::proved, 5, 4},
                                         ProofRow{.0848, Verdict::proved, 8, 7},
                                         ProofRow{.0849, Verdict::refuted, 0, 0},
                                         ProofRow{.1, Verdict::refuted, 0, 0}));

TEST(MarginProof, refutes_figure_6_beyond_its_margin_near_the_tabulated_place) {
  const MarginProof proof = prove_margin(test::figure6(kCubic), .0849);
  EXPECT_GE(proof.where.from, .78125);
  EXPECT_LE(proof.where.to, .7890625);
}

TEST(MarginProof, refutes_figure_5_at_once) {
  const MarginProof proof = prove_margin(test::figure5(kCubic), 0);
  EXPECT_EQ(proof.verdict, Verdict::refuted);
  EXPECT_LE(proof.depth, 2);
}

TEST(MarginProof, agrees_with_the_bounds_for_the_cyclide_law) {
  const Regularity r = regularity(test::figure6(kCyclide), {1e-9});
  EXPECT_EQ(prove_margin(test::figure6(kCyclide), r.lower - 1e-7).verdict, Verdict::proved);
  EXPECT_EQ(prove_margin(test::figure6(kCyclide), r.upper + 1e-7).verdict, Verdict::refuted);
}

TEST(MarginProof, knows_that_no_margin_exceeds_one) {
  EXPECT_EQ(prove_margin(test::straight_reducer(6, kCubic), .999).verdict, Verdict::proved);
  EXPECT_EQ(prove_margin(test::straight_reducer(6, kCubic), 1).verdict, Verdict::refuted);
  EXPECT_THROW((void)prove_margin(test::figure6(), std::nan("")), Error);
}

TEST(Regularity, of_straight_spines_is_one) {
  const Regularity hermite = regularity(test::straight_reducer(6, CyclideRadius{1, 9}));
  EXPECT_EQ(hermite.lower, 1);
  EXPECT_EQ(hermite.upper, 1);
  const Ring start{Vec3(0, 0, 0), -Vec3::UnitX(), 2}, end{Vec3(5, 0, 0), Vec3::UnitX(), 3};
  const Regularity line =
      regularity({start, end, LineSpine{start.center, end.center}, LinearRadius{2, 3}});
  EXPECT_EQ(line.lower, 1);
  EXPECT_EQ(line.upper, 1);
}

TEST(Regularity, of_an_arc_is_that_of_its_largest_ring) {
  const ArcSpine arc{Vec3(0, 0, 0), Vec3::UnitZ(), Vec3(3, 0, 0), 1};
  const Regularity torus = regularity({{}, {}, arc, ConstantRadius{1}});
  EXPECT_NEAR(torus.lower, 2. / 3, 1e-15);
  EXPECT_NEAR(torus.upper, 2. / 3, 1e-15);
  EXPECT_LE(torus.lower, torus.upper);
  const Regularity tapered = regularity({{}, {}, arc, LinearRadius{1, 4}});
  EXPECT_NEAR(tapered.lower, -1. / 3, 2e-6);
  ASSERT_EQ(tapered.folded.size(), 1u);
  EXPECT_NEAR(tapered.folded[0].from, 2. / 3, 1e-14);
  EXPECT_EQ(tapered.folded[0].to, 1);
}

TEST(Regularity, reports_where_the_spine_stops) {
  // k = l = 18 is where the straight reducer's velocity vanishes at t = 1/2; beyond, it turns back.
  const Regularity touching = regularity(test::straight_reducer(18, kCubic));
  EXPECT_EQ(touching.lower, -std::numeric_limits<double>::infinity());
  ASSERT_FALSE(touching.stops.empty());
  EXPECT_EQ(touching.minimum, touching.stops.front());
  EXPECT_NEAR(touching.stops.front().from, .5, 1e-12);
  const Regularity beyond = regularity(test::straight_reducer(20, kCubic));
  EXPECT_EQ(beyond.lower, -std::numeric_limits<double>::infinity());
  // x' = 20 - 84 t + 84 t^2.
  ASSERT_GE(beyond.stops.size(), 2u);
  EXPECT_NEAR(beyond.stops.front().from, .5 - std::sqrt(.25 - 20. / 84), 1e-12);
  EXPECT_NEAR(beyond.stops.back().to, .5 + std::sqrt(.25 - 20. / 84), 1e-12);
}

TEST(Regularity, of_a_standing_spine_is_no_claim) {
  const LineSpine point{Vec3(1, 1, 1), Vec3(1, 1, 1)};
  const Regularity r = regularity({{}, {}, point, ConstantRadius{1}});
  EXPECT_EQ(r.lower, -std::numeric_limits<double>::infinity());
  EXPECT_FALSE(r.stops.empty());
}

TEST(Regularity, refuses_a_width_of_nothing) {
  EXPECT_THROW((void)regularity(test::figure6(), {0}), Error);
}

TEST(Regularity, bounds_the_sampled_margin_of_random_blends) {
  std::mt19937_64 random(20066);
  std::uniform_real_distribution<double> coordinate(-5, 5), positive(.2, 12), radius(.1, 3);
  const auto vector = [&] {
    return Vec3(coordinate(random), coordinate(random), coordinate(random));
  };
  for (int i = 0; i < 60; ++i) {
    const HermiteSpine spine{vector(), vector(), positive(random) * vector().normalized(),
                             positive(random) * vector().normalized()};
    const double r0 = radius(random), r1 = radius(random);
    const RadiusLaw law =
        i % 2 == 0 ? RadiusLaw(CubicRadius{r0, r1}) : RadiusLaw(CyclideRadius{r0, r1});
    const Regularity r = regularity(test::ringed(spine, r0, r1, law), {1e-4});
    double sampled = 1;
    for (int k = 0; k <= 2000; ++k) {
      const double t = k / 2000.0;
      const double margin = 1 - curvature(evaluate(Spine(spine), t)) * evaluate(law, t).value;
      sampled = std::min(sampled, margin);
      if (margin < 0) {
        EXPECT_TRUE(std::any_of(r.folded.begin(), r.folded.end(), [t](const auto& f) {
          return f.from <= t && t <= f.to;
        })) << t;
      }
    }
    EXPECT_LE(r.lower, sampled);
    EXPECT_LE(r.upper, sampled + 1e-4 * (1 - sampled));
  }
}

TEST(Regularity, is_the_same_from_both_ends_and_after_a_turn) {
  const HermiteSpine s = test::skew_spine(10, 20);
  const RingedSurface back =
      test::ringed({s.to, s.from, -s.end_velocity, -s.start_velocity}, 2, 1, CubicRadius{2, 1});
  const Regularity there = regularity(test::figure6()), reversed = regularity(back);
  EXPECT_NEAR(there.lower, reversed.lower, 1e-6);
  const Eigen::Matrix3d turn(Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()));
  const RingedSurface turned =
      test::ringed({turn * s.from, turn * s.to, turn * s.start_velocity, turn * s.end_velocity}, 1,
                   2, CubicRadius{1, 2});
  EXPECT_NEAR(there.lower, regularity(turned).lower, 1e-6);
}

struct CurvatureRow {
  RingedSurface surface;
  double least_radius, at, least_clearance, clearance_at;
};

class RadiusOfCurvature : public testing::TestWithParam<CurvatureRow> {};

// The least value of a function near a place, by golden sections.
std::pair<double, double> least(const std::function<double(double)>& f, double place) {
  double a = place - .02, b = place + .02;
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  for (int i = 0; i < 60; ++i) {
    const double c = b - ratio * (b - a), d = a + ratio * (b - a);
    (f(c) < f(d) ? b : a) = f(c) < f(d) ? d : c;
  }
  return {f(a), a};
}

TEST_P(RadiusOfCurvature, and_its_clearance_are_least_where_the_table_says) {
  const CurvatureRow row = GetParam();
  const auto rho = [&](double t) { return 1 / curvature(evaluate(row.surface.spine, t)); };
  const auto clearance = [&](double t) { return rho(t) - evaluate(row.surface.radius, t).value; };
  EXPECT_NEAR(least(rho, row.at).first, row.least_radius, 6e-12);
  EXPECT_NEAR(least(rho, row.at).second, row.at, 1e-7);
  EXPECT_NEAR(least(clearance, row.clearance_at).first, row.least_clearance, 6e-10);
  EXPECT_NEAR(least(clearance, row.clearance_at).second, row.clearance_at, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Figures5And6, RadiusOfCurvature,
                         testing::Values(CurvatureRow{test::figure5(kCubic), 1.37206168553,
                                                      0.7193040945, -0.439440223609, 0.7253010375},
                                         CurvatureRow{test::figure5(kCyclide), 1.37206168553,
                                                      0.7193040945, -0.400713504029, 0.7266015841},
                                         CurvatureRow{test::figure6(kCubic), 2.05407464603,
                                                      0.7805145475, 0.174566388936, 0.7861126671},
                                         CurvatureRow{test::figure6(kCyclide), 2.05407464603,
                                                      0.7805145475, 0.198093729396, 0.7873485264}));

TEST(RadiusOfCurvature, at_the_ends_is_as_tabulated) {
  const auto rho = [](const RingedSurface& s, double t) {
    return 1 / curvature(evaluate(s.spine, t));
  };
  EXPECT_NEAR(rho(test::figure5(), 0), 6.374102691, 6e-10);
  EXPECT_NEAR(rho(test::figure5(), 1), 18.8219838508, 6e-11);
  EXPECT_NEAR(rho(test::figure6(), 0), 2.36623183907, 6e-12);
  EXPECT_NEAR(rho(test::figure6(), 1), 8.72404820633, 6e-12);
}

}  // namespace
}  // namespace dupin
