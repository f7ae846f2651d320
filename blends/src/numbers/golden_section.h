#pragma once

#include <utility>

namespace dupin::numbers {

template <class Value>
struct Minimum {
  double at = 0;
  Value value;
};

/// The least value of a function with one valley on [a, b], smooth or not, after `sections` steps
/// that each shrink the interval to 0.618 of its length. Values need only be ordered.
template <class Function>
[[nodiscard]] auto golden_section(const Function& f, double a, double b, int sections) {
  constexpr double kGolden = 0.6180339887498949;  // (sqrt(5) - 1) / 2
  double c = b - kGolden * (b - a), d = a + kGolden * (b - a);
  auto at_c = f(c), at_d = f(d);
  for (int i = 0; i < sections; ++i) {
    if (at_c < at_d) {
      b = std::exchange(d, c);
      at_d = at_c;
      c = b - kGolden * (b - a);
      at_c = f(c);
    } else {
      a = std::exchange(c, d);
      at_c = at_d;
      d = a + kGolden * (b - a);
      at_d = f(d);
    }
  }
  return at_c < at_d ? Minimum<decltype(at_c)>{c, at_c} : Minimum<decltype(at_c)>{d, at_d};
}

}  // namespace dupin::numbers
