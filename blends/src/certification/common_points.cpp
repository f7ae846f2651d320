#include "certification/common_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

namespace dupin::certification {
namespace {

struct Disc {
  double parameter = 0, radius = 0;
  Vec3 center = Vec3::Zero(), axis = Vec3::Zero();  // a ball has no axis
};

Disc disc_at(const SweptDiscs& sweep, double t) {
  const DiscHull hull = sweep.over({t, t});
  return {t, hull.radius.lower, hull.middle(), hull.tangents.empty() ? Vec3::Zero() : hull.axis};
}

Vec3 nearest_in(const Disc& disc, const Vec3& point) {
  const Vec3 from = point - disc.center;
  const Vec3 flat = from - from.dot(disc.axis) * disc.axis;
  const double length = flat.norm();
  return disc.center + (length > disc.radius ? disc.radius / length : 1) * flat;
}

// Discs of a part that is smaller by a share, some for each piece.
class Discs {
 public:
  Discs(const SweptDiscs& sweep, double less)
      : sweep_(sweep), less_(less), inset_(std::min(less, 0.01) / 2) {
    for (double i = 0; i < kDiscs * sweep.length(); ++i) {
      discs_.push_back(at((i + 0.5) / kDiscs));
    }
  }

  [[nodiscard]] const std::vector<Disc>& all() const { return discs_; }

  // Of the part to a point: that of the nearest disc, and of those beside it.
  [[nodiscard]] Vec3 nearest(const Vec3& point) const {
    const auto distance = [&](const Disc& disc) {
      return (nearest_in(disc, point) - point).norm();
    };
    Disc best = *std::ranges::min_element(discs_, {}, distance);
    const double piece = std::floor(best.parameter);
    for (double step = 0.5 / kDiscs; step > kFinest && !best.axis.isZero(); step /= 2) {
      for (const double t : {best.parameter - step, best.parameter + step}) {
        const Disc beside = at(std::clamp(t, piece + inset_, piece + 1 - inset_));
        if (distance(beside) < distance(best)) {
          best = beside;
        }
      }
    }
    return nearest_in(best, point);
  }

 private:
  static constexpr int kDiscs = 8;
  static constexpr double kFinest = 0x1p-24;

  [[nodiscard]] Disc at(double t) const {
    Disc disc = disc_at(sweep_, t);
    disc.radius *= 1 - less_;
    return disc;
  }

  const SweptDiscs& sweep_;
  double less_, inset_;  // of the radius, and of a piece
  std::vector<Disc> discs_;
};

bool are_few(const SweptDiscs& first, const SweptDiscs& second) {
  constexpr double kMostPairs = 1 << 10;  // of pieces
  const double pairs = first.length() * second.length();
  return pairs > 0 && pairs <= kMostPairs;
}

// A place between one of the first part and one of the second, by the parts' radii.
Vec3 between(const SweptDiscs& first, const Vec3& here, const SweptDiscs& second,
             const Vec3& there) {
  const double a = disc_at(first, 0.5).radius, b = disc_at(second, 0.5).radius;
  return here + a / (a + b) * (there - here);
}

// Centres of discs, those of the ends being the first and the last.
std::vector<Vec3> centers_of(const SweptDiscs& sweep) {
  constexpr double kOfPiece = 8;
  std::vector<Vec3> result;
  for (double i = 0; i <= kOfPiece * sweep.length(); ++i) {
    result.push_back(disc_at(sweep, i / kOfPiece).center);
  }
  return result;
}

// Of the segments from `a` along `u` and from `b` along `v`, where they are nearest, but for what
// rounding does to parallel ones.
std::pair<Vec3, Vec3> nearest_places(const Vec3& a, const Vec3& u, const Vec3& b, const Vec3& v) {
  const Vec3 between = a - b;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
  const double square = uu * vv - uv * uv;
  const auto share = [](double part, double whole) {
    return whole > 0 ? std::clamp(part / whole, 0., 1.) : 0;
  };
  double s = share(uv * v.dot(between) - vv * u.dot(between), square);
  const double t = share(v.dot(between) + s * uv, vv);
  s = share(t * uv - u.dot(between), uu);
  return {a + s * u, b + t * v};
}

// Between the axes where they are nearest, by the radii: from the nearest two discs on.
Vec3 start(const SweptDiscs& one, const SweptDiscs& other) {
  constexpr int kTurns = 20;
  constexpr double kAxis = 1;  // all of a disc but its centre is left out
  const Discs first(one, kAxis), second(other, kAxis);
  double least = std::numeric_limits<double>::infinity();
  Vec3 here = Vec3::Zero(), there = Vec3::Zero();
  for (const Disc& a : first.all()) {
    for (const Disc& b : second.all()) {
      const double apart = (a.center - b.center).norm();
      if (apart < least) {
        least = apart;
        here = a.center;
        there = b.center;
      }
    }
  }
  for (int i = 0; i < kTurns; ++i) {
    there = second.nearest(here);
    here = first.nearest(there);
  }
  return between(one, here, other, there);
}

// By going from part to part, which ends in both if they are convex, as they nearly are where they
// overlap little.
std::optional<Vec3> common_point(const Discs& first, const Discs& second, double less, Vec3 point) {
  constexpr int kTurns = 100;
  // What is so near to the smaller part is inside the part.
  const double near = less / 4 * std::min(first.all().front().radius, second.all().front().radius);
  for (int i = 0; i < kTurns; ++i) {
    const Vec3 there = second.nearest(point);
    point = first.nearest(there);
    if ((point - there).norm() <= near) {
      return point;
    }
  }
  return std::nullopt;
}

// Of a ball into which a part's end dips, by however little: on the axis, within both.
void append_within_ends(const SweptDiscs& sweep, const SweptDiscs& other,
                        std::vector<Vec3>& points) {
  const Disc ball = disc_at(other, 0);
  if (!ball.axis.isZero()) {
    return;
  }
  for (const double t : {0., sweep.length()}) {
    const Disc end = disc_at(sweep, t);
    const double depth = ball.radius - (end.center - ball.center).norm();
    if (depth > 0) {
      points.push_back(end.center + (t == 0 ? 0.5 : -0.5) * std::min(depth, end.radius) * end.axis);
    }
  }
}

}  // namespace

std::optional<Vec3> point_between_axes(const SweptDiscs& first, const SweptDiscs& second) {
  if (!are_few(first, second)) {
    return std::nullopt;
  }
  const std::vector<Vec3> here = centers_of(first), there = centers_of(second);
  std::pair<Vec3, Vec3> nearest{here.front(), there.front()};
  for (std::size_t i = 0; i + 1 < here.size(); ++i) {
    for (std::size_t k = 0; k + 1 < there.size(); ++k) {
      const auto places =
          nearest_places(here[i], here[i + 1] - here[i], there[k], there[k + 1] - there[k]);
      if ((places.first - places.second).norm() < (nearest.first - nearest.second).norm()) {
        nearest = places;
      }
    }
  }
  return between(first, nearest.first, second, nearest.second);
}

std::vector<Vec3> common_points(const SweptDiscs& first, const SweptDiscs& second) {
  std::vector<Vec3> result;
  if (!are_few(first, second)) {
    return result;
  }
  append_within_ends(first, second, result);
  append_within_ends(second, first, result);
  const Vec3 from = start(first, second);
  // What is common to smaller parts lies inside of both.
  for (const double less : {0.2, 0.03, 0.004, 0.0005}) {
    const auto point = common_point(Discs(first, less), Discs(second, less), less, from);
    if (point) {
      result.push_back(*point);
    }
  }
  return result;
}

}  // namespace dupin::certification
