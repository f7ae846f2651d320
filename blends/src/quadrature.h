#pragma once

#include <boost/math/quadrature/gauss.hpp>

namespace dupin::detail {

/// The integral of f over [0, 1]: 30-point Gauss-Legendre on each of 8 panels.
template <class Function>
[[nodiscard]] double integral(const Function& f) {
  constexpr int kPanels = 8;
  double sum = 0;
  for (int i = 0; i < kPanels; ++i) {
    sum += boost::math::quadrature::gauss<double, 30>::integrate(f, double(i) / kPanels,
                                                                 double(i + 1) / kPanels);
  }
  return sum;
}

}  // namespace dupin::detail
