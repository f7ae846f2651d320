#include "dupin/blends/ringed_regularity.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "numbers/polynomial.h"
#include "numbers/quaternion.h"

namespace dupin {
namespace {

using numbers::conjugate;
using numbers::product;

// The exact polynomial with these Bezier coefficients, as integers in Bernstein form, is positive.
bool is_positive(const numbers::Polynomial& polynomial) {
  const auto exact = numbers::bernstein(polynomial, polynomial.size() - 1);
  mpz_class common = 1;
  for (const mpq_class& x : exact) {
    common = lcm(common, x.get_den());
  }
  numbers::Bernstein whole;
  for (const mpq_class& x : exact) {
    whole.emplace_back(x.get_num() * (common / x.get_den()));
  }
  struct Leaf {
    numbers::Bernstein coefficients;
    int depth = 0;
  };
  constexpr int kMaxDepth = 40;
  std::vector<Leaf> stack{{whole}};
  while (!stack.empty()) {
    const Leaf leaf = std::move(stack.back());
    stack.pop_back();
    const auto& c = leaf.coefficients;
    if (std::all_of(c.begin(), c.end(), [](const mpz_class& x) { return sgn(x) > 0; })) {
      continue;
    }
    if (sgn(c.front()) <= 0 || sgn(c.back()) <= 0 || leaf.depth == kMaxDepth) {
      return false;
    }
    auto [left, right] = numbers::halves(c);
    stack.push_back({std::move(left), leaf.depth + 1});
    stack.push_back({std::move(right), leaf.depth + 1});
  }
  return true;
}

// The exact quaternion polynomial's coefficients; n = A i A*, |A|^2.
struct ExactRotation {
  numbers::VectorPolynomial normal;
  numbers::Polynomial square;
};

ExactRotation exact_rotation(const RationalRingedSurface& surface) {
  using ExactQuaternion = numbers::Quaternion<mpq_class>;
  std::array<numbers::Polynomial, 4> parts;
  for (std::size_t part = 0; part < 4; ++part) {
    std::vector<mpq_class> bezier;
    for (const auto& q : surface.rotation) {
      bezier.emplace_back(q[part]);
    }
    parts[part] = numbers::power_basis(bezier);
  }
  const std::size_t size = surface.rotation.size();
  const auto coefficient = [&](std::size_t i) {
    return ExactQuaternion{parts[0][i], parts[1][i], parts[2][i], parts[3][i]};
  };
  const ExactQuaternion unit{0, 1, 0, 0};
  ExactRotation result{numbers::VectorPolynomial(2 * size - 1), numbers::Polynomial(2 * size - 1)};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      const ExactQuaternion a = coefficient(i), b = numbers::conjugate(coefficient(j));
      const ExactQuaternion n = numbers::product(numbers::product(a, unit), b),
                            s = numbers::product(a, b);
      for (std::size_t part = 0; part < 3; ++part) {
        result.normal[i + j][part] += n[part + 1];
      }
      result.square[i + j] += s[0];
    }
  }
  return result;
}

numbers::Polynomial dot(const numbers::VectorPolynomial& a, const numbers::VectorPolynomial& b) {
  numbers::Polynomial c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      c[i + j] += dot(a[i], b[j]);
    }
  }
  return c;
}

numbers::Polynomial derivative(const numbers::Polynomial& p) {
  numbers::Polynomial c;
  for (std::size_t i = 1; i < p.size(); ++i) {
    c.push_back(mpq_class(static_cast<unsigned long>(i)) * p[i]);
  }
  return c;
}

numbers::Polynomial difference(numbers::Polynomial a, const numbers::Polynomial& b) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) {
    a[i] -= b[i];
  }
  return a;
}

// 1 for an end at which the circle's centre and plane stand still while its radius changes: there
// d'.n and |n'| vanish like t, or 1 - t, and the surface goes on into the circle's plane.
std::array<int, 2> standing_ends(const RationalRingedSurface& surface) {
  const auto& [center, radius, rotation] = surface;
  const std::size_t last = rotation.size() - 1;
  return {center[0] == center[1] && radius[0] != radius[1] && rotation[0] == rotation[1],
          center[3] == center[2] && radius[3] != radius[2] && rotation[last] == rotation[last - 1]};
}

// p / (t^start (1 - t)^end), which must divide it.
numbers::Polynomial divided(numbers::Polynomial p, int start, int end) {
  p.erase(p.begin(), p.begin() + start);
  for (; end > 0; --end) {
    // p = (1 - t) q: the coefficients of q are the sums of those of p.
    for (std::size_t i = 1; i < p.size(); ++i) {
      p[i] += p[i - 1];
    }
    p.pop_back();
  }
  return p;
}

}  // namespace

// With n of length s = |A|^2: discs are disjoint locally if and only if d'.n > 0 and
// (d'.n)^2 > rho^2 (|n'|^2 - s'^2).
bool proves_regular(const RationalRingedSurface& surface, double margin) {
  std::vector<numbers::ExactVec3> points;
  for (const Vec3& point : surface.center) {
    points.push_back(numbers::exact(point));
  }
  const auto velocity = numbers::derivative(numbers::power_basis(points));
  const auto radius =
      numbers::power_basis(std::vector<mpq_class>(surface.radius.begin(), surface.radius.end()));
  const ExactRotation rotation = exact_rotation(surface);
  const auto advance = dot(velocity, rotation.normal);
  const auto turning = difference(numbers::squared_norm(numbers::derivative(rotation.normal)),
                                  numbers::square(derivative(rotation.square)));
  const auto [start, end] = standing_ends(surface);
  numbers::Polynomial most{1 - mpq_class(margin)};
  const auto excess = difference(numbers::square(numbers::product(most, advance)),
                                 numbers::product(numbers::square(radius), turning));
  return is_positive(radius) && is_positive(divided(advance, start, end)) &&
         is_positive(divided(excess, 2 * start, 2 * end));
}

double certified_margin(const RationalRingedSurface& surface) {
  int proven = 0, open = 256;
  while (open - proven > 1) {
    const int middle = (proven + open) / 2;
    (proves_regular(surface, middle / 256.) ? proven : open) = middle;
  }
  return proven / 256.;
}

}  // namespace dupin
