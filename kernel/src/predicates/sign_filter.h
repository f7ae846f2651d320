#pragma once

#include <array>
#include <cmath>

#include "dupin/kernel/vec.h"

/// Predicates on points that doubles hold: first in plain doubles, then, where rounding could reach
/// the value, in exact numbers. So decide the tests of two triangles (triangle_overlap.h: whether
/// they meet; triangle_distance.h: how near they come) and of what stays as it is while points move
/// within a margin (stable_predicates.h, for the lemmas of docs/robustness.md).
///
/// Here are the signs of determinants in plain doubles: +1 or -1 when certain, 0 when rounding
/// could reach the value. The bounds are stage A of [She97]. The small addends cover underflow;
/// overflow gives infinities or NaN, which are never certain.
namespace dupin::predicates {

inline constexpr double kHalfUlp = 0x1p-53;
inline constexpr double kOrient2Bound = (3 + 16 * kHalfUlp) * kHalfUlp;
inline constexpr double kOrient3Bound = (7 + 56 * kHalfUlp) * kHalfUlp;

/// The sides of one plane.
class PlaneFilter {
 public:
  PlaneFilter(const Vec3& a, const Vec3& b, const Vec3& c) : a_(a) {
    const Vec3 u = b - a, v = c - a;
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const double left = u[i] * v[j], right = u[j] * v[i];
      normal_[k] = left - right;
      size_[k] = std::abs(left) + std::abs(right) + kUnderflow;
    }
  }

  /// The sign of (b - a) x (c - a) . (p - a).
  [[nodiscard]] int side(const Vec3& p) const {
    const double x = p[0] - a_[0], y = p[1] - a_[1], z = p[2] - a_[2];
    const double value = x * normal_[0] + y * normal_[1] + z * normal_[2];
    const double bound =
        kOrient3Bound * (std::abs(x) * size_[0] + std::abs(y) * size_[1] + std::abs(z) * size_[2]) +
        kUnderflow;
    return (value > bound) - (value < -bound);
  }

  /// True only if a, b and c are certainly not collinear.
  [[nodiscard]] bool certain() const {
    for (int k = 0; k < 3; ++k) {
      if (std::abs(normal_[k]) > kOrient2Bound * size_[k] + kUnderflow) {
        return true;
      }
    }
    return false;
  }

  /// The axis nearest to the normal: to project along.
  [[nodiscard]] int main_axis() const {
    int axis = 0;
    normal_.cwiseAbs().maxCoeff(&axis);
    return axis;
  }

 private:
  // Each product that underflows is off by at most 2^-1075; this is far more, and far less than
  // any product of coordinates above 1e-90.
  static constexpr double kUnderflow = 0x1p-900;
  Vec3 a_, normal_, size_;
};

/// The sign of (b - a) x (p - a) seen along `axis`.
[[nodiscard]] inline int side_of_line(const Vec3& a, const Vec3& b, const Vec3& p, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double left = (b[i] - a[i]) * (p[j] - a[j]), right = (b[j] - a[j]) * (p[i] - a[i]);
  const double value = left - right;
  const double bound = kOrient2Bound * (std::abs(left) + std::abs(right)) + 0x1p-1000;
  return (value > bound) - (value < -bound);
}

/// The edges of one triangle, seen along an axis.
class EdgeFilter {
 public:
  EdgeFilter(const std::array<Vec3, 3>& triangle, int axis)
      : i_((axis + 1) % 3), j_((axis + 2) % 3) {
    const int inner = side_of_line(triangle[0], triangle[1], triangle[2], axis);
    for (int k = 0; k < 3; ++k) {
      const Vec3 &from = triangle[k], &to = triangle[(k + 1) % 3];
      edges_[k] = {from[i_], from[j_], inner * (to[i_] - from[i_]), inner * (to[j_] - from[j_])};
    }
  }

  /// True only if the line through edge `k`, from corner k on, certainly has the triangle on one
  /// side and the point on the other one.
  [[nodiscard]] bool is_beyond(int k, const Vec3& p) const {
    const Edge& edge = edges_[k];
    const double left = edge.along_i * (p[j_] - edge.j), right = edge.along_j * (p[i_] - edge.i);
    return left - right < -(kOrient2Bound * (std::abs(left) + std::abs(right)) + 0x1p-1000);
  }

 private:
  struct Edge {
    double i, j, along_i, along_j;
  };
  int i_, j_;
  std::array<Edge, 3> edges_;
};

/// True only if d lies inside the circle through a, b, c beyond doubt. The bound is stage A of
/// the incircle test of [She97], (10 + 96 u) u times the permanent, u = 2^-52 as rounding is
/// upward; the addend covers underflow.
[[nodiscard]] inline bool certainly_in_circle(const std::array<double, 2>& a,
                                              const std::array<double, 2>& b,
                                              const std::array<double, 2>& c,
                                              const std::array<double, 2>& d) {
  const double ax = a[0] - d[0], ay = a[1] - d[1], bx = b[0] - d[0], by = b[1] - d[1],
               cx = c[0] - d[0], cy = c[1] - d[1];
  const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  const double value =
      aa * (bx * cy - by * cx) + bb * (cx * ay - cy * ax) + cc * (ax * by - ay * bx);
  const double permanent = aa * (std::abs(bx * cy) + std::abs(by * cx)) +
                           bb * (std::abs(cx * ay) + std::abs(cy * ax)) +
                           cc * (std::abs(ax * by) + std::abs(ay * bx));
  return value > 12 * 0x1p-52 * permanent + 0x1p-900;
}

}  // namespace dupin::predicates
