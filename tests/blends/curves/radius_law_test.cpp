#include "dupin/blends/radius_law.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace dupin {
namespace {

struct CyclideRow {
  double start, end, t, radius;
};

class CyclideRadiusTable : public testing::TestWithParam<CyclideRow> {};

TEST_P(CyclideRadiusTable, has_the_tabulated_value) {
  const CyclideRow row = GetParam();
  EXPECT_NEAR(evaluate(CyclideRadius{row.start, row.end}, row.t).value, row.radius,
              2e-15 * row.end);
}

INSTANTIATE_TEST_SUITE_P(Values, CyclideRadiusTable,
                         testing::Values(CyclideRow{1, 4, .1, 1.030068257361276},
                                         CyclideRow{1, 4, .25, 1.203186112754533},
                                         CyclideRow{1, 4, .5, 2},
                                         CyclideRow{1, 4, .75, 3.324506456314175},
                                         CyclideRow{1, 4, .9, 3.883237806246737},
                                         CyclideRow{1, 9, .1, 1.040578983012716},
                                         CyclideRow{1, 9, .25, 1.294678500871470},
                                         CyclideRow{1, 9, .5, 3},
                                         CyclideRow{1, 9, .75, 6.951532750363851},
                                         CyclideRow{1, 9, .9, 8.649031113373945}));

TEST(CyclideRadius, has_the_tabulated_slopes) {
  EXPECT_NEAR(evaluate(CyclideRadius{1, 9}, .25).first, 2.790180773533113, 5e-15);
  EXPECT_NEAR(evaluate(CyclideRadius{1, 9}, .5).first, 12.56637061435917, 1e-14);
}

TEST(CyclideRadius, multiplies_with_its_mirror_to_the_product_of_the_ends) {
  for (const double end : {0.01, 1.0, 3.0, 1e6}) {
    for (int i = 0; i <= 50; ++i) {
      const double t = i / 50.0;
      const double product =
          evaluate(CyclideRadius{1, end}, t).value * evaluate(CyclideRadius{1, end}, 1 - t).value;
      EXPECT_NEAR(product / end, 1, 1e-14) << end << ' ' << t;
    }
  }
}

TEST(CyclideRadius, curves_at_the_ends_as_its_closed_form_says) {
  const double r0 = 1.5, r1 = 4, rise = r1 - r0, pi2 = std::numbers::pi * std::numbers::pi;
  EXPECT_NEAR(evaluate(CyclideRadius{r0, r1}, 0).second, pi2 * rise * r0 / (r0 + r1), 1e-13);
  EXPECT_NEAR(evaluate(CyclideRadius{r0, r1}, 1).second, -pi2 * rise * r1 / (r0 + r1), 1e-13);
}

TEST(RadiusLaw, meets_its_ends_exactly_and_the_blend_laws_flatly) {
  const double r0 = 0.1, r1 = 0.7;
  for (const RadiusLaw& law :
       {RadiusLaw(LinearRadius{r0, r1}), RadiusLaw(CubicRadius{r0, r1}),
        RadiusLaw(CyclideRadius{r0, r1}), RadiusLaw(CyclideRadius{r1, r0})}) {
    const bool falling = evaluate(law, 0).value != r0;
    EXPECT_EQ(evaluate(law, 0).value, falling ? r1 : r0);
    EXPECT_EQ(evaluate(law, 1).value, falling ? r0 : r1);
    if (!std::holds_alternative<LinearRadius>(law)) {
      EXPECT_EQ(evaluate(law, 0).first, 0);
      EXPECT_EQ(evaluate(law, 1).first, 0);
    }
  }
}

TEST(RadiusLaw, has_the_derivatives_of_its_values) {
  // Central differences: error h^2/6 R''' plus rounding eps/h, both below 1e-6 here.
  const double h = 1e-5;
  for (const RadiusLaw& law :
       {RadiusLaw(ConstantRadius{2}), RadiusLaw(LinearRadius{1, 3}), RadiusLaw(CubicRadius{1, 2}),
        RadiusLaw(CyclideRadius{1, 2}), RadiusLaw(CyclideRadius{3, 1})}) {
    for (const double t : {.1, .3, .5, .62, .9}) {
      const RadiusValue before = evaluate(law, t - h), at = evaluate(law, t),
                        after = evaluate(law, t + h);
      EXPECT_NEAR(at.first, (after.value - before.value) / (2 * h), 1e-6);
      EXPECT_NEAR(at.second, (after.first - before.first) / (2 * h), 1e-6);
    }
  }
}

TEST(RadiusLaw, is_monotone_between_its_ends) {
  for (const RadiusLaw& law : {RadiusLaw(CubicRadius{1, 9}), RadiusLaw(CyclideRadius{1, 9})}) {
    for (int i = 0; i < 1000; ++i) {
      EXPECT_LT(evaluate(law, i / 1000.0).value, evaluate(law, (i + 1) / 1000.0).value);
    }
  }
}

}  // namespace
}  // namespace dupin
