#pragma once

#include <vector>

namespace dupin::numbers {

/// Nodes and weights of a quadrature over [0, 1].
struct Quadrature {
  std::vector<double> nodes, weights;
};

/// 30-point Gauss-Legendre on each of `panels` equal panels, nodes ascending.
[[nodiscard]] Quadrature gauss_panels(int panels);

/// The integral of f over [0, 1].
template <class Function>
[[nodiscard]] double integral(const Function& f, const Quadrature& rule) {
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    sum += rule.weights[i] * f(rule.nodes[i]);
  }
  return sum;
}

/// The integral of f over [0, 1] on 8 panels.
template <class Function>
[[nodiscard]] double integral(const Function& f) {
  static const Quadrature rule = gauss_panels(8);
  return integral(f, rule);
}

}  // namespace dupin::numbers
