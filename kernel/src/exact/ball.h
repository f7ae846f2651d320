#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace dupin::exact {

/// A real number to about 100 bits: it is no further than `radius` from high + low. For signs that
/// intervals of doubles leave open, at a fraction of the cost of exact numbers. Needs rounding
/// upward in the calling thread, so that a radius is rounded outward; what overflows, or is divided
/// by what may be zero, has a radius that is infinite or no number, and no sign.
///
/// Lemmas, for rounding in any one direction: if |a| >= |b| and s is a + b rounded, then s - a is a
/// double, so that b - (s - a) is off what s leaves of a + b by its own rounding alone (S. Boldo,
/// S. Graillat, J.-M. Muller, On the robustness of the 2Sum and Fast2Sum algorithms, 2017). What a
/// rounded product leaves is a double, unless it underflows, and fma gives it.
class Ball {
 public:
  Ball() = default;
  Ball(double value) : high_(value) {}
  Ball(double high, double low, double radius) : high_(high), low_(low), radius_(radius) {}

  [[nodiscard]] double high() const { return high_; }
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double radius() const { return radius_; }

  [[nodiscard]] double infimum() const { return -((radius_ - low_) - high_); }
  [[nodiscard]] double supremum() const { return (radius_ + low_) + high_; }
  /// +1 or -1, or 0 where it may be either or zero.
  [[nodiscard]] int sign() const { return (infimum() > 0) - (supremum() < 0); }

  friend Ball operator-(const Ball& a) { return {-a.high_, -a.low_, a.radius_}; }
  friend Ball operator-(const Ball& a, const Ball& b) { return a + -b; }
  friend Ball operator+(const Ball& a, const Ball& b) {
    const Sum leading = sum(a.high_, b.high_);
    const double rests = std::abs(a.low_) + std::abs(b.low_) + std::abs(leading.rest);
    const Sum all = sum(leading.value, a.low_ + b.low_ + leading.rest);
    return made(all, a.radius_ + b.radius_ + kRests * rests);
  }
  friend Ball operator*(const Ball& a, const Ball& b) {
    const double product = a.high_ * b.high_, rest = std::fma(a.high_, b.high_, -product);
    const double x = a.high_ * b.low_, y = a.low_ * b.high_;
    const Sum all = sum(product, rest + (x + y));
    const double rests = std::abs(rest) + std::abs(x) + std::abs(y);
    return made(all, kRests * rests + std::abs(a.low_) * std::abs(b.low_) +
                         a.magnitude() * b.radius_ +
                         (std::abs(b.high_) + std::abs(b.low_)) * a.radius_ + kUnderflow);
  }
  /// The rest that two digits of a quotient leave, divided by the least that b may be.
  friend Ball operator/(const Ball& a, const Ball& b) {
    const double first = a.high_ / b.high_;
    const Ball left = a - Ball(first) * b;
    const double second = left.high_ / b.high_;
    const Ball rest = left - Ball(second) * b;
    const double least = -(std::abs(b.low_) + b.radius_ - std::abs(b.high_));
    const Sum all = sum(first, second);
    return made(all,
                least > 0 ? rest.magnitude() / least : std::numeric_limits<double>::infinity());
  }

 private:
  struct Sum {
    double value, rest;
  };
  // Sums of rests are rounded three times at most, each by less than 2^-52 of what they are made
  // of; of the last sum the rest is below 2^-52 of it, and rounded once.
  static constexpr double kRests = 0x1p-50, kRest = 0x1p-103;
  static constexpr double kUnderflow = 0x1p-1000;
  // Rounded upward, sums and products stop at the least double.
  static constexpr double kOverflow = 0x1p1000;

  static Sum sum(double a, double b) {
    if (std::abs(a) < std::abs(b)) {
      std::swap(a, b);
    }
    const double value = a + b;
    return {value, b - (value - a)};
  }
  static Ball made(const Sum& all, double radius) {
    const double size = std::abs(all.value);
    return {all.value, all.rest,
            size < kOverflow ? radius + kRest * size : std::numeric_limits<double>::infinity()};
  }
  [[nodiscard]] double magnitude() const { return std::abs(high_) + std::abs(low_) + radius_; }

  double high_ = 0, low_ = 0, radius_ = 0;
};

using BallPoint = std::array<Ball, 3>;

}  // namespace dupin::exact
