#include "dupin/kernel/enclosure.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "support/message_of.h"

namespace dupin {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double next(double value) { return std::nextafter(value, kInfinity); }

mpq_class random_rational(std::mt19937& random) {
  const auto number = [&] { return static_cast<long>(random() % 2000001) - 1000000; };
  mpq_class value(number(), std::abs(number()) + 1);
  value.canonicalize();
  return value;
}

TEST(Enclosure, of_a_rational_is_the_doubles_around_it) {
  std::mt19937 random(1);
  for (int i = 0; i < 5000; ++i) {
    const mpq_class value = random_rational(random);
    const Enclosure around = enclosure_of(value);
    ASSERT_LE(mpq_class(around.lower), value);
    ASSERT_GE(mpq_class(around.upper), value);
    const bool is_double = mpq_class(value.get_d()) == value;
    ASSERT_EQ(around.upper, is_double ? around.lower : next(around.lower)) << value;
  }
  EXPECT_EQ(enclosure_of(mpq_class(1, 3)).lower, 1.0 / 3);  // to the nearest is down
}

TEST(Enclosure, of_a_root_is_the_doubles_around_it) {
  std::mt19937 random(2);
  for (int i = 0; i < 5000; ++i) {
    const mpq_class square = abs(random_rational(random));
    const Enclosure root = root_of(square);
    const mpq_class lower(root.lower), upper(root.upper);
    ASSERT_LE(lower * lower, square);
    ASSERT_GE(upper * upper, square);
    ASSERT_EQ(root.upper, lower * lower == square ? root.lower : next(root.lower));
    const mpq_class exact(std::abs(square.get_d()));
    ASSERT_EQ(root_of(exact * exact), (Enclosure{square.get_d(), square.get_d()}));
  }
}

TEST(Enclosure, of_an_angle_contains_it) {
  std::mt19937 random(3);
  for (int i = 0; i < 5000; ++i) {
    const mpq_class sine = random_rational(random), cosine = random_rational(random);
    const mpq_class squared = sine * sine;
    if (sine == 0 && cosine == 0) {
      continue;
    }
    const Enclosure angle = angle_of(squared, cosine);
    const double about = std::atan2(std::abs(sine.get_d()), cosine.get_d());
    ASSERT_LE(angle.lower, about + 1e-15);
    ASSERT_GE(angle.upper, about - 1e-15);
    ASSERT_LE(angle.upper, next(angle.lower));
    // The angles on both sides of the axis make half a turn.
    const Enclosure half = angle + angle_of(squared, -cosine);
    ASSERT_LE(half.lower, std::numbers::pi);
    ASSERT_GE(half.upper, next(std::numbers::pi)) << "pi lies between these";
  }
  EXPECT_EQ(angle_of(0, 5), (Enclosure{0, 0}));
}

TEST(Enclosure, of_a_sum_rounds_outward) {
  std::mt19937 random(4);
  for (int i = 0; i < 5000; ++i) {
    const Enclosure a = enclosure_of(random_rational(random)),
                    b = enclosure_of(random_rational(random)), sum = a + b;
    const mpq_class lower = mpq_class(a.lower) + mpq_class(b.lower),
                    upper = mpq_class(a.upper) + mpq_class(b.upper);
    ASSERT_LE(mpq_class(sum.lower), lower);
    ASSERT_GT(mpq_class(next(sum.lower)), lower);
    ASSERT_GE(mpq_class(sum.upper), upper);
    ASSERT_LT(mpq_class(std::nextafter(sum.upper, -kInfinity)), upper);
    ASSERT_EQ(-(-sum), sum);
  }
}

TEST(Enclosure, of_a_sum_without_bounds_has_none) {
  EXPECT_EQ((Enclosure{0, kInfinity} + Enclosure{0, 1}), (Enclosure{0, kInfinity}));
  EXPECT_EQ((Enclosure{-kInfinity, 2} + Enclosure{-kInfinity, kInfinity}),
            (Enclosure{-kInfinity, kInfinity}));
  constexpr double kLargest = std::numeric_limits<double>::max();
  const Enclosure twice = Enclosure{kLargest, kLargest} + Enclosure{kLargest, kLargest};
  EXPECT_EQ(twice, (Enclosure{kLargest, kInfinity}));
  EXPECT_EQ((twice + Enclosure{1, 1}), twice);
}

TEST(Enclosure, of_a_sum_of_what_encloses_nothing_is_refused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Enclosure& bad :
       {Enclosure{nan, 1}, Enclosure{0, nan}, Enclosure{kInfinity, kInfinity},
        Enclosure{-kInfinity, -kInfinity}}) {
    EXPECT_NE(test::message_of(
                  [&] {
                    (void)(bad + Enclosure{0, 1});
                  },
                  Errc::invalid_argument),
              "no error");
    EXPECT_NE(test::message_of(
                  [&] {
                    (void)(Enclosure{0, 1} + bad);
                  },
                  Errc::invalid_argument),
              "no error");
  }
}

}  // namespace
}  // namespace dupin
