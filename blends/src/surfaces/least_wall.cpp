#include "surfaces/least_wall.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/interval.h"
#include "ringed/second_derivatives.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin::surfaces {
namespace {

using numbers::Interval;

constexpr int kCells = 64, kDirections = 1024;  // of parameters, and of directions
// Above the steepest easing of an ellipse's turn.
constexpr double kSteepest = 2;
// Of the radius: what the bore's stored numbers are off by, at most.
constexpr double kRounding = 0x1p-48;

Interval cell(int i, int count = kCells) { return {double(i) / count, double(i + 1) / count}; }

// All laws but Bezier's are monotone.
Interval radii(const RadiusLaw& law, const Interval& t) {
  if (std::holds_alternative<BezierRadius>(law)) {
    return {smallest_radius(law), largest_radius(law)};
  }
  const double start = evaluate(law, t.lower).value, end = evaluate(law, t.upper).value;
  const double slack = kRounding * largest_radius(law);
  return {std::min(start, end) - slack, std::max(start, end) + slack};
}

// Of ellipses with these semi-axes, over all directions.
double ellipse_wall(const Interval& a, const Interval& b, double wall) {
  double least = std::numeric_limits<double>::infinity();
  const auto support = [](const Interval& x, const Interval& y, const Interval& c,
                          const Interval& s) {
    return numbers::sqrt(square(x) * c + square(y) * s);
  };
  for (int i = 0; i < kDirections; ++i) {
    const Interval c = cell(i, kDirections), s = Interval(1) - c;
    const Interval both =
        support(a, b, c, s) + support(a - Interval(wall), b - Interval(wall), c, s);
    const Interval left = Interval(wall) * (Interval(2) * (a * c + b * s) - Interval(wall)) / both;
    least = std::min(least, left.lower);
  }
  return least;
}

struct Widening {
  double margin, slope = 0;

  [[nodiscard]] double of(double wall) const {
    const Interval m = margin, s = slope;
    return slope == 0 ? wall : (Interval(wall) * m / numbers::sqrt(square(m) + square(s))).lower;
  }
};

// Of a radius, by the way along the spine.
double steepest(const Spine& spine, const RadiusLaw& law, const Interval& t) {
  if (std::holds_alternative<ConstantRadius>(law)) {
    return 0;
  }
  return (Interval(ringed::radius_bounds(law, t).first) / ringed::spine_bounds(spine, t).speed)
      .upper;
}

struct LeastWall {
  double wall;

  std::optional<double> operator()(const RingedSurface& tube) const {
    Widening widening{margin_bounds(tube).lower};
    for (int i = 0; i < kCells; ++i) {
      widening.slope = std::max(widening.slope, steepest(tube.spine, tube.radius, cell(i)));
    }
    return widening.of(wall) - kRounding * largest_radius(tube.radius);
  }

  std::optional<double> operator()(const EllipticTube& tube) const {
    Widening widening{margin_bounds(tube).lower};
    double across = wall;
    for (int i = 0; i < kCells; ++i) {
      const Interval t = cell(i);
      const Interval a = radii(tube.first, t), b = radii(tube.second, t);
      across = std::min(across, ellipse_wall(a, b, wall));
      const Interval turning = Interval(std::abs(tube.turn) * kSteepest) * (a - b).magnitude() /
                               ringed::spine_bounds(tube.spine, t).speed;
      widening.slope = std::max(widening.slope, std::max(steepest(tube.spine, tube.first, t),
                                                         steepest(tube.spine, tube.second, t)) +
                                                    (tube.turn == 0 ? 0 : turning.upper));
    }
    return widening.of(across) -
           kRounding * std::max(largest_radius(tube.first), largest_radius(tube.second));
  }

  std::optional<double> operator()(const CyclidePiece& /*piece*/) const { return wall; }
  std::optional<double> operator()(const RationalRingedTube& /*tube*/) const { return {}; }
};

}  // namespace

double ellipse_wall(double a, double b, double wall) {
  return ellipse_wall(Interval(a), Interval(b), wall);
}

std::optional<double> least_wall(const PartSurface& surface, double wall) {
  const auto* chain = std::get_if<Chain>(&surface);
  double least = wall;
  if (chain != nullptr) {
    for (const Piece& piece : chain->pieces) {
      const auto here = std::visit(LeastWall{wall}, piece);
      if (!here || !(*here > 0)) {
        return std::nullopt;
      }
      least = std::min(least, *here);
    }
  }
  return least;
}

}  // namespace dupin::surfaces
