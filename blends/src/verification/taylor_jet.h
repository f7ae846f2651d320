#pragma once

#include <algorithm>
#include <cstddef>

#include "verification/jet.h"

namespace dupin::verification {

/// An enclosure over a stretch, by Taylor's formula, of the derivative of an order: `middle` are
/// the derivatives at a parameter in it, `all` those on all of it, of which the last is taken, and
/// `reach` is how far the parameter gets from there.
template <std::size_t count>
[[nodiscard]] Interval taylor_sum(const Jet<count>& middle, const Jet<count>& all, double reach,
                                  std::size_t order) {
  const Interval h(-reach, reach);
  Interval sum = 0, power = 1;  // h^i / i!
  for (std::size_t i = 0; order + i < count; ++i) {
    sum = sum + power * (order + i + 1 < count ? middle : all)[order + i];
    power = power * h / Interval(double(i + 1));
  }
  return sum;
}

/// Enclosures of derivatives by Taylor's formula, as far as they are better.
template <std::size_t count, std::size_t more>
[[nodiscard]] Jet<count> by_taylor(const Jet<more>& middle, const Jet<more>& all, double reach) {
  static_assert(count < more);
  Jet<count> result;
  for (std::size_t k = 0; k < count; ++k) {
    result[k] = intersection(taylor_sum(middle, all, reach, k), all[k]);
  }
  return result;
}

template <std::size_t count, std::size_t more>
[[nodiscard]] JetVec<count> by_taylor(const JetVec<more>& middle, const JetVec<more>& all,
                                      double reach) {
  return {by_taylor<count>(middle[0], all[0], reach), by_taylor<count>(middle[1], all[1], reach),
          by_taylor<count>(middle[2], all[2], reach)};
}

}  // namespace dupin::verification
