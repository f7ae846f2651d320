#pragma once

#include <vector>

#include <boost/math/quadrature/gauss.hpp>

namespace dupin::detail {

/// Nodes and weights of a quadrature over [0, 1].
struct Quadrature {
  std::vector<double> nodes, weights;
};

/// 30-point Gauss-Legendre on each of `panels` equal panels, nodes ascending.
[[nodiscard]] inline Quadrature gauss_panels(int panels) {
  using Rule = boost::math::quadrature::gauss<double, 30>;
  const auto& half = Rule::abscissa();
  const auto count = static_cast<int>(half.size());
  Quadrature result;
  for (int panel = 0; panel < panels; ++panel) {
    for (int i = -count; i < count; ++i) {
      // The rule lists the positive half of its symmetric nodes.
      const auto k = static_cast<std::size_t>(i < 0 ? -i - 1 : i);
      const double x = i < 0 ? -half[k] : half[k];
      result.nodes.push_back((panel + (1 + x) / 2) / panels);
      result.weights.push_back(Rule::weights()[k] / (2 * panels));
    }
  }
  return result;
}

/// The integral of f over [0, 1] on 8 panels.
template <class Function>
[[nodiscard]] double integral(const Function& f) {
  const Quadrature rule = gauss_panels(8);
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    sum += rule.weights[i] * f(rule.nodes[i]);
  }
  return sum;
}

}  // namespace dupin::detail
