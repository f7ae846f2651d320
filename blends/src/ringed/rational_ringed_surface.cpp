#include "dupin/blends/rational_ringed_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "numbers/bezier.h"
#include "numbers/polynomial.h"
#include "numbers/quadrature.h"
#include "numbers/quaternion.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

using numbers::conjugate;
using numbers::product;
using Quaternion = numbers::Quaternion<double>;

constexpr std::array<Quaternion, 3> kUnits{{{0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

Vec3 vector_part(const Quaternion& q) { return {q[1], q[2], q[3]}; }

struct Rate {
  Vec3 value, rate;
};

// n, E1, E2 divided by |A|^2, with their derivatives.
struct MovingFrame {
  Rate normal, first, second;
};

MovingFrame frame_at(const RationalRingedSurface& surface, double t) {
  std::vector<Eigen::Array4d> points;
  for (const Quaternion& q : surface.rotation) {
    points.emplace_back(q[0], q[1], q[2], q[3]);
  }
  const auto jet = numbers::bezier_jet(points, t);
  const Quaternion a{jet[0][0], jet[0][1], jet[0][2], jet[0][3]};
  const Quaternion b{jet[1][0], jet[1][1], jet[1][2], jet[1][3]};
  const double square = jet[0].square().sum(), change = 2 * (jet[0] * jet[1]).sum();
  const auto rotated = [&](const Quaternion& unit) {
    const Vec3 value =
        vector_part(numbers::product(numbers::product(a, unit), numbers::conjugate(a))) / square;
    // (b u a* + a u b*) is twice the vector part of b u a*.
    const Vec3 rate =
        2 * vector_part(numbers::product(numbers::product(b, unit), numbers::conjugate(a))) /
        square;
    return Rate{value, rate - change / square * value};
  };
  return {rotated(kUnits[0]), rotated(kUnits[1]), rotated(kUnits[2])};
}

// The Bernstein coefficients of a product.
template <class A, class B, class Multiply>
auto bernstein_product(const std::vector<A>& a, const std::vector<B>& b, const Multiply& multiply) {
  const auto binomial = [](std::size_t n, std::size_t k) {
    return 1 / ((static_cast<double>(n) + 1) *
                std::beta(static_cast<double>(n - k) + 1, static_cast<double>(k) + 1));
  };
  const std::size_t n = a.size() - 1, m = b.size() - 1;
  using Value = std::decay_t<decltype(multiply(a[0], b[0]))>;
  std::vector<Value> c(n + m + 1, Value(0 * multiply(a[0], b[0])));
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= m; ++j) {
      c[i + j] += binomial(n, i) * binomial(m, j) / binomial(n + m, i + j) * multiply(a[i], b[j]);
    }
  }
  return c;
}

using numbers::conjugate;
using numbers::product;

// The exact polynomial with these Bezier coefficients, as integers in Bernstein form, is positive.
bool is_positive(const numbers::Polynomial& polynomial) {
  const numbers::OverDenominator whole(numbers::bernstein(polynomial, polynomial.size() - 1));
  struct Leaf {
    numbers::Bernstein coefficients;
    int depth = 0;
  };
  constexpr int kMaxDepth = 40;
  std::vector<Leaf> stack{{whole.numerators}};
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

MovingRing ring_at(const RationalRingedSurface& surface, double t) {
  const MovingFrame frame = frame_at(surface, t);
  const auto d =
      numbers::bezier_jet(std::vector<Vec3>(surface.center.begin(), surface.center.end()), t);
  const auto rho =
      numbers::bezier_jet(std::vector<double>(surface.radius.begin(), surface.radius.end()), t);
  return {d[0], frame.normal.value, rho[0], d[1], rho[1], frame.normal.rate};
}

SurfacePoint evaluate(const RationalRingedSurface& surface, double t, double v) {
  const MovingRing ring = ring_at(surface, t);
  const MovingFrame frame = frame_at(surface, t);
  const double c = std::cos(v), s = std::sin(v);
  const Vec3 e = c * frame.first.value + s * frame.second.value;
  const Vec3 e_t = c * frame.first.rate + s * frame.second.rate;
  const Vec3 e_v = c * frame.second.value - s * frame.first.value;
  const double across = ring.radius_rate + ring.center_rate.dot(e);
  const double advance = ring.center_rate.dot(ring.normal) - ring.radius * ring.normal_rate.dot(e);
  return {ring.center + ring.radius * e,
          ring.center_rate + ring.radius_rate * e + ring.radius * e_t, ring.radius * e_v,
          (advance * e - across * ring.normal).normalized()};
}

double disc_margin(const RationalRingedSurface& surface, double t) {
  const MovingRing ring = ring_at(surface, t);
  return ring.center_rate.dot(ring.normal) - ring.radius * ring.normal_rate.norm();
}

double area(const RationalRingedSurface& surface) {
  constexpr int kAngles = 256;  // of the trapezoid rule, which converges geometrically
  return numbers::integral([&](double t) {
    double sum = 0;
    for (int i = 0; i < kAngles; ++i) {
      const SurfacePoint x = evaluate(surface, t, 2 * kPi * i / kAngles);
      sum += x.along.cross(x.around).norm();
    }
    return 2 * kPi * sum / kAngles;
  });
}

double volume(const RationalRingedSurface& surface) {
  return kPi * numbers::integral([&](double t) {
           const MovingRing ring = ring_at(surface, t);
           return ring.radius * ring.radius * ring.center_rate.dot(ring.normal);
         });
}

RationalPatch rational_patch(const RationalRingedSurface& surface, double v0, double v1) {
  const auto rotated = [&](const Quaternion& unit) {
    return bernstein_product(
        surface.rotation, surface.rotation, [&](const Quaternion& a, const Quaternion& b) {
          return vector_part(numbers::product(numbers::product(a, unit), numbers::conjugate(b)));
        });
  };
  const auto square = bernstein_product(
      surface.rotation, surface.rotation, [](const Quaternion& a, const Quaternion& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
      });
  const auto scaled = [](const auto& a, const auto& b) { return Vec3(a * b); };
  const std::vector<double> radius(surface.radius.begin(), surface.radius.end());
  const std::vector<Vec3> center(surface.center.begin(), surface.center.end());
  const auto middle = bernstein_product(square, center, scaled);
  const auto first = bernstein_product(radius, rotated(kUnits[1]), scaled);
  const auto second = bernstein_product(radius, rotated(kUnits[2]), scaled);
  const auto weight = bernstein_product(square, std::vector<double>{1, 1, 1, 1},
                                        [](double a, double b) { return a * b; });
  // The arc's control points (1, cos v0, sin v0), (cos h, cos m, sin m), (1, cos v1, sin v1).
  const double half = (v1 - v0) / 2, mean = (v0 + v1) / 2;
  const std::array<Vec3, 3> arc{Vec3(1, std::cos(v0), std::sin(v0)),
                                Vec3(std::cos(half), std::cos(mean), std::sin(mean)),
                                Vec3(1, std::cos(v1), std::sin(v1))};
  RationalPatch patch;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    auto& row = patch.net.emplace_back();
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3 point = arc[j][0] * middle[i] + arc[j][1] * first[i] + arc[j][2] * second[i];
      row[j] = {point.x(), point.y(), point.z(), arc[j][0] * weight[i]};
    }
  }
  return patch;
}

Vec3 evaluate(const RationalPatch& patch, double t, double s) {
  std::vector<Eigen::Array4d> across;
  for (std::size_t j = 0; j < 3; ++j) {
    std::vector<Eigen::Array4d> along;
    for (const auto& row : patch.net) {
      along.emplace_back(row[j][0], row[j][1], row[j][2], row[j][3]);
    }
    across.push_back(numbers::bezier_jet(along, t)[0]);
  }
  const Eigen::Array4d point = numbers::bezier_jet(across, s)[0];
  return Vec3(point[0], point[1], point[2]) / point[3];
}

// With n of length s = |A|^2: discs are disjoint locally if and only if d'.n > 0 and
// (d'.n)^2 > rho^2 (|n'|^2 - s'^2).
bool proves_regular(const RationalRingedSurface& surface, double margin) {
  if (!std::isfinite(margin)) {
    throw Error(Errc::invalid_argument,
                "the margin to prove must be finite, not " + decimal(margin, kMessageDigits));
  }
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
