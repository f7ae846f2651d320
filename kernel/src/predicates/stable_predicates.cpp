#include "predicates/stable_predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace dupin::predicates {
namespace {

/// The sides of the plane through three points that move.
class StablePlane {
 public:
  StablePlane(const Vec3& a, const Vec3& b, const Vec3& c, double margin) : a_(a), margin_(margin) {
    const Vec3 u = b - a, v = c - a;
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      normal_[k] = u[i] * v[j] - u[j] * v[i];
      error_[k] = error_of_cross(u, v, i, j, margin);
    }
  }

  /// The side of a point that moves as well; 0 if it may change.
  [[nodiscard]] int side(const Vec3& p) const {
    constexpr double kRounding = 8 * kHalfUlp;  // of p - a, three products and their sum
    const Vec3 w = p - a_;
    double value = 0, bound = 0;
    for (int k = 0; k < 3; ++k) {
      const double size = std::abs(w[k]);
      value += w[k] * normal_[k];
      bound +=
          size * error_[k] + (2 * margin_ + kRounding * size) * (std::abs(normal_[k]) + error_[k]);
    }
    bound = bound * kStableMore + kStableUnderflow;
    return (value > bound) - (value < -bound);
  }

  /// But for rounding and moves.
  [[nodiscard]] const Vec3& normal() const { return normal_; }

  /// The axis nearest to the normal.
  [[nodiscard]] int main_axis() const {
    int axis = 0;
    normal_.cwiseAbs().maxCoeff(&axis);
    return axis;
  }

 private:
  Vec3 a_, normal_, error_;
  double margin_;
};

bool has(const Triangle& t, std::uint32_t corner) {
  return t[0] == corner || t[1] == corner || t[2] == corner;
}

/// Two triangles; what is asked of them is not symmetric.
struct Pair {
  std::span<const Vec3> points;
  const Triangle &s, &t;
  double margin;

  /// Whether the corners of t that s has not are all on one side of the plane.
  [[nodiscard]] bool is_beside(const StablePlane& plane_of_s) const {
    int side = 0;
    for (const std::uint32_t q : t) {
      if (has(s, q)) {
        continue;
      }
      const int next = plane_of_s.side(points[q]);
      if (next == 0 || next == -side) {
        return false;
      }
      side = next;
    }
    return side != 0;
  }

  /// Whether, seen along `axis`, t lies beyond an edge of s, on whose line it may have the edge's
  /// corners.
  [[nodiscard]] bool is_beyond_edge(int axis) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = s[i], to = s[(i + 1) % 3];
      const auto side = [&](std::uint32_t p) {
        return stable_side_of_line(points[from], points[to], points[p], axis, margin);
      };
      const int inner = side(s[(i + 2) % 3]);
      if (inner != 0 && std::ranges::all_of(t, [&](std::uint32_t q) {
            return q == from || q == to || side(q) == -inner;
          })) {
        return true;
      }
    }
    return false;
  }

  /// Whether all of s is farther one way than all of t, but for one corner that they may share.
  [[nodiscard]] bool is_split_by(const Vec3& way) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    struct Range {
      double low = kInfinity, high = -kInfinity;
      void add(double position) {
        low = std::min(low, position);
        high = std::max(high, position);
      }
    };
    Range only_s, only_t, common;
    double size = 0;
    const auto position = [&](std::uint32_t corner) {
      const Vec3 terms = way.cwiseProduct(points[corner] - points[s[0]]);
      size += terms.cwiseAbs().sum();  // infinite if any is
      return terms.sum();
    };
    for (const std::uint32_t p : s) {
      (has(t, p) ? common : only_s).add(position(p));
    }
    for (const std::uint32_t q : t) {
      if (!has(s, q)) {
        only_t.add(position(q));
      }
    }
    const double bound =
        (2 * margin * way.cwiseAbs().sum() + 16 * kHalfUlp * size) * kStableMore + kStableUnderflow;
    const auto is_below = [&](const Range& one, const Range& other) {
      return other.low - one.high > bound &&
             (common.low > common.high ||
              (common.low - one.high > bound && other.low - common.high > bound));
    };
    return is_below(only_s, only_t) || is_below(only_t, only_s);
  }
};

/// Whether a plane between the triangles, which share one corner at most, is upright on one and
/// along an edge of it, or is along an edge of each: if there is one at all, there is such a one.
bool are_split(const Pair& pair, const Vec3& normal_of_s, const Vec3& normal_of_t) {
  if (std::ranges::count_if(pair.t, [&](std::uint32_t q) { return has(pair.s, q); }) > 1) {
    return false;
  }
  const auto edge = [&](const Triangle& triangle, std::size_t i) -> Vec3 {
    return pair.points[triangle[(i + 1) % 3]] - pair.points[triangle[i]];
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 of_s = edge(pair.s, i), of_t = edge(pair.t, i);
    if (pair.is_split_by(normal_of_s.cross(of_s)) || pair.is_split_by(normal_of_t.cross(of_t))) {
      return true;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (pair.is_split_by(of_s.cross(edge(pair.t, k)))) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

bool keeps_area(const Vec3& a, const Vec3& b, const Vec3& c, double margin) {
  int axis = 0;
  (b - a).cross(c - a).cwiseAbs().maxCoeff(&axis);
  return stable_side_of_line(a, b, c, axis, margin) != 0;
}

bool is_small_margin(std::span<const Vec3> points, std::span<const Triangle> triangles,
                     double margin) {
  constexpr std::size_t kSamples = 4096, kOthers = 20;  // one in so many may be slivers
  constexpr double kTimes = 8;
  const std::size_t step = std::max<std::size_t>(1, triangles.size() / kSamples);
  std::size_t samples = 0, flat = 0;
  for (std::size_t i = 0; i < triangles.size(); i += step) {
    const auto& [a, b, c] = triangles[i];
    ++samples;
    flat += keeps_area(points[a], points[b], points[c], kTimes * margin) ? 0 : 1;
  }
  return flat * kOthers <= samples;
}

bool keep_apart(std::span<const Vec3> points, const Triangle& s, const Triangle& t, double margin) {
  const Pair st{points, s, t, margin}, ts{points, t, s, margin};
  const StablePlane plane_of_s(points[s[0]], points[s[1]], points[s[2]], margin);
  if (st.is_beside(plane_of_s)) {
    return true;
  }
  const StablePlane plane_of_t(points[t[0]], points[t[1]], points[t[2]], margin);
  return ts.is_beside(plane_of_t) || st.is_beyond_edge(plane_of_s.main_axis()) ||
         ts.is_beyond_edge(plane_of_t.main_axis()) ||
         are_split(st, plane_of_s.normal(), plane_of_t.normal());
}

}  // namespace dupin::predicates
