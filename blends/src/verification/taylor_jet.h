#pragma once

#include "verification/jet.h"

namespace dupin::verification {

/// Enclosures over a stretch by Taylor's formula, as far as they are better: `middle` are the
/// derivatives at a parameter in it, `all` those on all of it, and `reach` is how far the parameter
/// gets from there.
template <std::size_t count, std::size_t more>
[[nodiscard]] Jet<count> by_taylor(const Jet<more>& middle, const Jet<more>& all, double reach) {
  static_assert(count < more);
  const Interval h(-reach, reach);
  Jet<count> result;
  for (std::size_t k = 0; k < count; ++k) {
    Interval sum = 0, power = 1;  // h^i / i!
    for (std::size_t i = 0; k + i < more; ++i) {
      sum = sum + power * (k + i + 1 < more ? middle : all)[k + i];
      power = power * h / Interval(double(i + 1));
    }
    result[k] = {std::max(sum.lower, all[k].lower), std::min(sum.upper, all[k].upper)};
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
