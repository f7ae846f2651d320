#include "assembly/parts/head_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "assembly/parts/line_and_arc.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

constexpr double kTip = 1.0 / 256;  // of the radius
constexpr int kDegree = 9;
// Of a turn by so much, Taylor polynomials of this degree are off by less than 1e-10.
constexpr double kLargestTurn = std::numbers::pi / 4;

// (level + height sin x, center + width cos x): along the axis, and off it.
struct MeridianArc {
  double level = 0, height = 1, center = 0, width = 1;
  [[nodiscard]] double along(double x) const { return level + height * std::sin(x); }
  [[nodiscard]] double off(double x) const { return center + width * std::cos(x); }
};

using Coefficients = std::array<double, kDegree + 1>;

double binomial(int n, int k) {
  double result = 1;
  for (int i = 1; i <= k; ++i) {
    result = result * (n - k + i) / i;
  }
  return result;
}

// Bernstein coefficients on [from, to] of sin(x + phase), by its Taylor polynomial in the middle.
Coefficients sine(double from, double to, double phase) {
  const double half = (to - from) / 2, middle = std::midpoint(from, to) + phase;
  Coefficients powers{};  // of t: x = from + t (to - from), s = 2 t - 1
  double factor = 1;      // half^k / k!
  for (int k = 0; k <= kDegree; ++k) {
    const double term = factor * std::sin(middle + k * std::numbers::pi / 2);
    for (int j = 0; j <= k; ++j) {
      powers[std::size_t(j)] +=
          term * binomial(k, j) * std::ldexp(1.0, j) * ((k - j) % 2 == 0 ? 1 : -1);
    }
    factor *= half / (k + 1);
  }
  Coefficients result{};
  for (int i = 0; i <= kDegree; ++i) {
    for (int j = 0; j <= i; ++j) {
      result[std::size_t(i)] += binomial(i, j) / binomial(kDegree, j) * powers[std::size_t(j)];
    }
  }
  return result;
}

class Head {
 public:
  explicit Head(const Ring& start) : start_(start), last_(start) {}

  // The arc from x = `from` to `to`, in turns that polynomials follow.
  void append(const MeridianArc& arc, double from, double to) {
    const int count = std::max(1, int(std::ceil((to - from) / kLargestTurn)));
    for (int i = 0; i < count; ++i) {
      append_turn(arc, from + (to - from) * i / count, from + (to - from) * (i + 1) / count);
    }
  }

  PartSurface take() { return Chain(pieces_); }

 private:
  [[nodiscard]] Vec3 point(double along) const {
    return start_.center + along * opposite(start_.normal);
  }

  void append_turn(const MeridianArc& arc, double from, double to) {
    const Coefficients sines = sine(from, to, 0), cosines = sine(from, to, std::numbers::pi / 2);
    BezierSpine spine;
    BezierRadius radius;
    for (std::size_t i = 0; i < sines.size(); ++i) {
      spine.points.push_back(point(arc.level + arc.height * sines[i]));
      radius.coefficients.push_back(arc.center + arc.width * cosines[i]);
    }
    const double slope = -arc.width * std::sin(to) / (arc.height * std::cos(to));
    const Ring end{plain(point(arc.along(to))), opposite(start_.normal), arc.off(to), slope};
    spine.points.front() = last_.center;
    spine.points.back() = end.center;
    radius.coefficients.front() = last_.radius;
    radius.coefficients.back() = end.radius;
    pieces_.push_back({last_, end, std::move(spine), std::move(radius)});
    last_ = flipped(end);
  }

  Ring start_, last_;  // where the next piece begins
  std::vector<RingedSurface> pieces_;
};

struct Drawn {
  const Ring& start;

  PartSurface operator()(const EllipsoidProfile& ellipsoid) const {
    Head head(start);
    head.append({0, ellipsoid.depth, 0, start.radius}, 0, std::acos(kTip));
    return head.take();
  }

  // The centres of crown and knuckle lie in one line with the point where they meet.
  PartSurface operator()(const TorisphereProfile& torisphere) const {
    const auto& [crown, knuckle] = torisphere;
    const double off = start.radius - knuckle, apart = crown - knuckle;
    const double behind = std::sqrt(apart * apart - off * off);
    const double meeting = std::atan2(behind, off);
    Head head(start);
    head.append({0, knuckle, off, knuckle}, 0, meeting);
    head.append({-behind, crown, 0, crown}, meeting, std::acos(kTip * start.radius / crown));
    return head.take();
  }
};

double less_wall(double length, double wall, const std::string& what) {
  if (!(length > wall)) {
    throw Error(Errc::infeasible_blend, "a wall of " + decimal(wall, kMessageDigits) +
                                            " leaves nothing inside of the head: its " + what +
                                            " is " + decimal(length, kMessageDigits));
  }
  return length - wall;
}

struct Inner {
  double wall;

  HeadProfile operator()(const EllipsoidProfile& ellipsoid) const {
    return EllipsoidProfile{less_wall(ellipsoid.depth, wall, "depth")};
  }
  HeadProfile operator()(const TorisphereProfile& torisphere) const {
    return TorisphereProfile{torisphere.crown - wall,
                             less_wall(torisphere.knuckle, wall, "knuckle's radius")};
  }
};

}  // namespace

PartSurface head_surface(const Ring& start, const HeadProfile& profile) {
  return std::visit(Drawn{start}, profile);
}

PartSurface inner_head(const Ring& start, const HeadProfile& profile, double wall) {
  Ring inner = start;
  inner.radius = less_wall(inner.radius, wall, "radius");
  return head_surface(inner, std::visit(Inner{wall}, profile));
}

}  // namespace dupin::assembly
