#include <gtest/gtest.h>

#include "canal/centered_series.h"
#include "numbers/cosine_and_sine.h"

namespace dupin::canal {
namespace {

using numbers::Interval;
constexpr std::size_t kOrders = 8;
using Centered = CenteredSeries<kOrders>;

struct Waves {
  Centered cosine, sine;
};

Waves waves(double from, double to) {
  const double middle = (from + to) / 2;
  const auto [c, s] = numbers::cosine_and_sine(Interval(middle));
  const auto [over_c, over_s] = numbers::cosine_and_sine(Interval(from, to));
  const Interval offsets = Interval(from, to) - middle;
  return {{wave<kOrders>(c, -s, 1), wave<kOrders>(over_c, -over_s, 1), offsets},
          {wave<kOrders>(s, c, 1), wave<kOrders>(over_s, over_c, 1), offsets}};
}

// What depends on the parameter in many ways, in the end in none or in one.
template <class T>
std::array<T, 4> functions(const T& cosine, const T& sine) {
  const T tangent = sine / cosine, squared = square(tangent) + T(1);
  return {square(cosine) * squared, square_root(squared) * cosine, squared - square(tangent),
          sine / (tangent + T(2)) - 0.5 * (-sine)};
}

TEST(CenteredSeries, hold_what_is_at_every_place) {
  const auto [cosine, sine] = waves(0.6, 0.8);
  const auto all = functions(cosine, sine);
  for (const double t : {0.6, 0.63, 0.7, 0.77, 0.8}) {
    const Waves at = waves(t, t);
    const auto exact = functions(at.cosine.all, at.sine.all);
    for (std::size_t f = 0; f < all.size(); ++f) {
      for (std::size_t k = 0; k < kOrders; ++k) {
        EXPECT_LE(all.at(f).all.at.at(k).lower, exact.at(f).at.at(k).upper) << f << ' ' << k;
        EXPECT_GE(all.at(f).all.at.at(k).upper, exact.at(f).at.at(k).lower) << f << ' ' << k;
      }
    }
  }
}

TEST(CenteredSeries, are_narrow_however_often_the_parameter_occurs) {
  const auto [cosine, sine] = waves(0.6, 0.8);
  const auto centered = functions(cosine, sine), plain_ones = [&] {
    std::array<Centered, 4> result;
    const auto plain = functions(cosine.all, sine.all);
    for (std::size_t f = 0; f < 4; ++f) {
      result.at(f).all = plain.at(f);
    }
    return result;
  }();
  const auto width = [](const Centered& s) { return s.all.at[0].upper - s.all.at[0].lower; };
  for (std::size_t f = 0; f < 3; ++f) {
    EXPECT_LT(width(centered.at(f)), 1e-3) << "it is 1";
    EXPECT_GT(width(plain_ones.at(f)), 0.1);
  }
  EXPECT_LT(width(centered[3]), width(plain_ones[3]));
}

TEST(CenteredSeries, have_derivatives_of_which_one_less_is_known) {
  const auto [cosine, sine] = waves(0.6, 0.8);
  const auto rate = derivative(sine);
  const auto shorter = shortened(cosine);
  EXPECT_EQ(rate.all.at.size(), kOrders - 1);
  EXPECT_NEAR(rate.all.at[0].lower, shorter.all.at[0].lower, 1e-12);
  EXPECT_NEAR(rate.middle.at[1].upper, shorter.middle.at[1].upper, 1e-12);
}

}  // namespace
}  // namespace dupin::canal
