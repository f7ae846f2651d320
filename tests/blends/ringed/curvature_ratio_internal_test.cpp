#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "ringed/curvature_ratio.h"
#include "support/paper_surfaces.h"

namespace dupin::ringed {
namespace {

double squared_ratio(const RingedSurface& surface, double t) {
  const double x = curvature(evaluate(surface.spine, t)) * evaluate(surface.radius, t).value;
  return x * x;
}

const BezierSpine kRational{{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(3, 1, 0), Vec3(3, 3, 1)},
                            {1, 2, .5, 1}};

std::vector<RingedSurface> surfaces() {
  const ArcSpine arc{Vec3(0, 0, 0), Vec3::UnitZ(), Vec3(4, 0, 0), 1.5};
  const LineSpine line{Vec3(0, 0, 0), Vec3(1, 2, 3)};
  return {test::figure6(),
          test::figure6(CyclideRadius{1, 2}),
          test::figure6(CyclideRadius{2, 1}),
          {{}, {}, kRational, BezierRadius{{.5, .7, .3}}},
          {{}, {}, kRational, CyclideRadius{.5, .2}},
          {{}, {}, arc, LinearRadius{1, 2}},
          {{}, {}, line, CyclideRadius{1, 2}}};
}

// All leaves of this depth.
std::vector<CurvatureRatio::Leaf> leaves(const CurvatureRatio& ratio, int depth) {
  std::vector<CurvatureRatio::Leaf> all{ratio.whole()};
  for (int i = 0; i < depth; ++i) {
    std::vector<CurvatureRatio::Leaf> next;
    for (const auto& leaf : all) {
      auto [left, right] = ratio.split(leaf);
      next.push_back(std::move(left));
      next.push_back(std::move(right));
    }
    all = std::move(next);
  }
  return all;
}

TEST(CurvatureRatio, range_holds_the_samples_of_every_leaf) {
  for (const RingedSurface& surface : surfaces()) {
    const CurvatureRatio ratio(surface);
    for (const int depth : {0, 3, 6}) {
      for (const auto& leaf : leaves(ratio, depth)) {
        const numbers::Interval range = ratio.range(leaf);
        for (int i = 0; i <= 4; ++i) {
          const double t = std::lerp(leaf.from, leaf.to, i / 4.), x = squared_ratio(surface, t);
          EXPECT_LE(range.lower, x * (1 + 1e-12) + 1e-15) << t;
          EXPECT_GE(range.upper, x * (1 - 1e-12) - 1e-15) << t;
        }
        if (depth == 6) {
          EXPECT_LT(range.upper - range.lower, .3);
        }
      }
    }
  }
}

TEST(CurvatureRatio, at_the_ends_of_a_leaf_is_that_of_the_spine) {
  for (const RingedSurface& surface : surfaces()) {
    const CurvatureRatio ratio(surface);
    for (const auto& leaf : leaves(ratio, 4)) {
      for (const bool at_end : {false, true}) {
        const numbers::Interval found = at_end ? ratio.at_end(leaf) : ratio.at_start(leaf);
        const double x = squared_ratio(surface, at_end ? leaf.to : leaf.from);
        EXPECT_LE(found.lower, x * (1 + 1e-11));
        EXPECT_GE(found.upper, x * (1 - 1e-11));
        EXPECT_LE(found.upper - found.lower, 1e-14 * found.upper + 1e-300);
      }
    }
  }
}

TEST(CurvatureRatio, claims_are_proved_above_and_refuted_below_the_samples) {
  for (const RingedSurface& surface : surfaces()) {
    const CurvatureRatio ratio(surface);
    for (const auto& leaf : leaves(ratio, 7)) {
      const double most =
          std::max(squared_ratio(surface, leaf.from), squared_ratio(surface, leaf.to));
      EXPECT_TRUE(
          ratio.proves_below(leaf, mpq_class(ratio.range(leaf).upper) + mpq_class(1, 1000)));
      EXPECT_FALSE(ratio.proves_below(leaf, .999 * most));
      EXPECT_FALSE(ratio.refutes_below(leaf, 1.001 * most + 1e-9));
      if (most > 1e-6) {
        EXPECT_TRUE(ratio.refutes_below(leaf, .999 * most));
      }
    }
  }
}

// Exactly: kappa R = 1/2 all along this arc, squared 1/4.
TEST(CurvatureRatio, of_polynomials_decides_equality) {
  const RingedSurface elbow{
      {}, {}, ArcSpine{Vec3(0, 0, 0), Vec3::UnitZ(), Vec3(4, 0, 0), 1.5}, ConstantRadius{2}};
  const CurvatureRatio ratio(elbow);
  EXPECT_FALSE(ratio.proves_below(ratio.whole(), mpq_class(1, 4)));
  EXPECT_TRUE(ratio.refutes_below(ratio.whole(), mpq_class(1, 4)));
  const mpq_class more = mpq_class(1, 4) + mpq_class(1, mpz_class(1) << 200);
  EXPECT_TRUE(ratio.proves_below(ratio.whole(), more));
  EXPECT_FALSE(ratio.refutes_below(ratio.whole(), more));
}

TEST(CurvatureRatio, of_a_spine_that_stops_is_without_bounds) {
  const RingedSurface surface{
      {},
      {},
      BezierSpine{{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)}},
      ConstantRadius{1}};
  const CurvatureRatio ratio(surface);
  EXPECT_EQ(ratio.range(ratio.whole()).lower, 0);
  EXPECT_TRUE(std::isinf(ratio.range(ratio.whole()).upper));
  EXPECT_TRUE(std::isinf(ratio.at_start(ratio.whole()).lower));
  EXPECT_FALSE(ratio.proves_below(ratio.whole(), 1000000));
}

TEST(CurvatureRatio, squared_curvature_is_that_of_the_spine) {
  const auto value = [](const numbers::Polynomial& p, double t) {
    mpq_class sum;
    for (std::size_t i = p.size(); i > 0; --i) {
      sum = sum * mpq_class(t) + p[i - 1];
    }
    return sum.get_d();
  };
  for (const RingedSurface& surface : surfaces()) {
    const SquaredCurvature found = squared_curvature(surface.spine);
    for (const double t : {0., .3, 1.}) {
      const double kappa = curvature(evaluate(surface.spine, t));
      EXPECT_NEAR(value(found.numerator, t) / value(found.denominator, t), kappa * kappa,
                  1e-12 * (1 + kappa * kappa));
    }
  }
}

TEST(CurvatureRatio, refuses_radii_that_are_none) {
  RingedSurface surface = test::figure6();
  for (const CyclideRadius& law : {CyclideRadius{-1, -2}, CyclideRadius{0, 1},
                                   CyclideRadius{1, std::numeric_limits<double>::infinity()}}) {
    surface.radius = law;
    EXPECT_THROW(CurvatureRatio{surface}, Error);
  }
}

}  // namespace
}  // namespace dupin::ringed
