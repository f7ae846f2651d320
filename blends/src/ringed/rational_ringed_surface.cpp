#include "dupin/blends/rational_ringed_surface.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "numbers/bezier.h"
#include "numbers/quadrature.h"
#include "numbers/quaternion.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

using numbers::conjugate;
using numbers::product;
using Quaternion = numbers::Quaternion<double>;

const std::array<Quaternion, 3> kUnits{{{0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

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

}  // namespace dupin
