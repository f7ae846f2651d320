#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "ringed/blend_search.h"
#include "support/paper_surfaces.h"

namespace dupin::ringed {
namespace {

const double kScale = std::sqrt(116.);  // the distance of the ends of the skew spine

BlendFamily family() {
  return [](double k, double l) {
    return test::ringed(test::skew_spine(k, l), 1, 2, CubicRadius{1, 2});
  };
}

struct Measures {
  double energy = 0, length = 0, margin = 1;
};

Measures measured(const RingedSurface& surface) {
  constexpr int kSteps = 4000;
  Measures m;
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + .5) / kSteps;
    const SpinePoint y = evaluate(surface.spine, t);
    const double kappa = curvature(y), speed = y.first.norm();
    m.energy += kappa * kappa * speed / kSteps;
    m.length += speed / kSteps;
    m.margin = std::min(m.margin, 1 - kappa * evaluate(surface.radius, t).value);
  }
  return m;
}

TEST(BlendSearch, says_what_its_blends_measure) {
  const BlendSearch search(family(), kScale, {}, {});
  for (const auto& found :
       {search.least_energy(.05), search.largest_margin(), search.nearest(.05, 10, 20)}) {
    ASSERT_TRUE(found);
    const Measures expected = measured(family()(found->k, found->l));
    EXPECT_NEAR(found->energy, expected.energy, 1e-5);
    EXPECT_NEAR(found->length, expected.length, 1e-5);
    EXPECT_NEAR(found->margin, expected.margin, 1e-5);
  }
}

// Against a grid that knows nothing of the search.
TEST(BlendSearch, finds_no_less_than_a_grid_does) {
  const BlendSearch search(family(), kScale, {}, {});
  const auto widest = search.largest_margin();
  ASSERT_TRUE(widest);
  const double margin = widest->margin / 2;
  const auto best = search.least_energy(margin);
  ASSERT_TRUE(best);
  EXPECT_GE(best->margin, margin);
  for (double a = -2; a <= 1.5; a += .25) {
    for (double b = -2; b <= 1.5; b += .25) {
      const double k = kScale * std::exp(a), l = kScale * std::exp(b);
      const Measures other = measured(family()(k, l));
      if (k > 5 * kScale || l > 5 * kScale || other.length > 3 * kScale) {
        continue;
      }
      EXPECT_LE(other.margin, widest->margin + 1e-6);
      if (other.margin >= margin) {
        EXPECT_GE(other.energy, best->energy - 1e-6);
      }
    }
  }
}

TEST(BlendSearch, keeps_the_speeds_that_are_given) {
  const BlendSearch half(family(), kScale, 10, {}), fixed(family(), kScale, 10, 20);
  EXPECT_NEAR(half.least_energy(.05)->k, 10, 1e-12);
  EXPECT_NEAR(fixed.largest_margin()->k, 10, 1e-12);
  EXPECT_NEAR(fixed.largest_margin()->l, 20, 1e-12);
  EXPECT_NEAR(fixed.largest_margin()->margin, 0.0848584660472, 1e-9);
}

TEST(BlendSearch, is_near_what_is_wanted_where_that_will_do) {
  const BlendSearch search(family(), kScale, {}, {});
  const auto found = search.nearest(.05, 10, 20);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->k, 10, 1e-4);
  EXPECT_NEAR(found->l, 20, 1e-4);
  // Figure 5 folds: what is nearest to it just has the margin.
  const auto remedy = search.nearest(.05, 18, 25);
  ASSERT_TRUE(remedy);
  EXPECT_GE(remedy->margin, .05);
  EXPECT_LT(remedy->margin, .0501);
}

TEST(BlendSearch, finds_none_where_there_is_none) {
  EXPECT_FALSE(BlendSearch(family(), kScale, {}, {}).least_energy(.9));
  EXPECT_FALSE(BlendSearch(family(), kScale, {}, {}).nearest(.9, 10, 20));
  // Speeds whose spine is longer than three times the scale are not allowed.
  EXPECT_FALSE(BlendSearch(family(), kScale, 1000, 1000).largest_margin());
}

}  // namespace
}  // namespace dupin::ringed
