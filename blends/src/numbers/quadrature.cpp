#include "numbers/quadrature.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace dupin::numbers {
namespace {

constexpr int kPoints = 30;

// The Legendre polynomial of degree kPoints and its derivative at x in (-1, 1).
std::pair<long double, long double> legendre(long double x) {
  long double before = 1, here = x;
  for (int n = 2; n <= kPoints; ++n) {
    before = std::exchange(here, ((2 * n - 1) * x * here - (n - 1) * before) / n);
  }
  return {here, kPoints * (x * here - before) / (x * x - 1)};
}

struct Node {
  long double x = 0, weight = 0;
};

// On [-1, 1], ascending.
std::array<Node, kPoints> gauss_legendre() {
  std::array<Node, kPoints> rule;
  for (int i = 0; i < kPoints; ++i) {
    // Newton's method from the well-known estimate; six steps reach the last bits.
    long double x = -std::cos(std::numbers::pi * (i + 0.75) / (kPoints + 0.5));
    for (int step = 0; step < 6; ++step) {
      const auto [value, slope] = legendre(x);
      x -= value / slope;
    }
    const long double slope = legendre(x).second;
    rule[i] = {x, 2 / ((1 - x * x) * slope * slope)};
  }
  return rule;
}

}  // namespace

Quadrature gauss_panels(int panels) {
  static const std::array<Node, kPoints> nodes = gauss_legendre();
  Quadrature rule;
  for (int panel = 0; panel < panels; ++panel) {
    for (const auto& [x, weight] : nodes) {
      rule.nodes.push_back(static_cast<double>((panel + (1 + x) / 2) / panels));
      rule.weights.push_back(static_cast<double>(weight / (2 * panels)));
    }
  }
  return rule;
}

}  // namespace dupin::numbers
