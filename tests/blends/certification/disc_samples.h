#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "blends/tubes.h"
#include "dupin/blends/part_surface.h"

/// The discs of chains of ringed surfaces, point by point: from the spines and laws themselves.
namespace dupin::test {

struct SampledDisc {
  Vec3 center, normal;
  double radius;

  /// The middle, and points on the border and half-way there.
  [[nodiscard]] std::vector<Vec3> points() const {
    std::vector<Vec3> result = {center};
    const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
    constexpr int kAngles = 12;
    for (int k = 0; k < kAngles; ++k) {
      const double angle = 2 * std::numbers::pi * k / kAngles;
      for (const double reach : {0.5, 1.0}) {
        result.push_back(center + reach * radius * (std::cos(angle) * u + std::sin(angle) * v));
      }
    }
    return result;
  }

  /// By how much the point is inside the ball that has the disc for a great circle.
  [[nodiscard]] double depth(const Vec3& point) const { return radius - (point - center).norm(); }
  [[nodiscard]] double height(const Vec3& point) const { return (point - center).dot(normal); }
};

/// The disc at a parameter of the chain, i + t on the i-th piece.
inline SampledDisc disc_at(const Chain& chain, double t) {
  const std::size_t piece = std::min(static_cast<std::size_t>(t), chain.pieces.size() - 1);
  const auto& tube = std::get<RingedSurface>(chain.pieces[piece]);
  const SpinePoint y = evaluate(tube.spine, t - static_cast<double>(piece));
  return {y.position, y.first.normalized(),
          evaluate(tube.radius, t - static_cast<double>(piece)).value};
}

/// Whether a disc at some parameter within `t` has the point well inside: it passes by the point
/// there, and wherever it may do so the point is nearer to its centre than the border.
inline bool is_inside(const Chain& chain, const ParameterInterval& t, const Vec3& point) {
  constexpr int kSteps = 64;
  bool passes = false, is_deep = true;
  double before = disc_at(chain, t.from).height(point);
  for (int i = 1; i <= kSteps; ++i) {
    const SampledDisc disc = disc_at(chain, std::lerp(t.from, t.to, double(i) / kSteps));
    const double after = disc.height(point);
    passes = passes || (before >= 0 && after <= 0);
    is_deep = is_deep && disc.depth(point) > 0;
    before = after;
  }
  return passes && is_deep;
}

/// A pipe that turns by three quarters of a circle and then goes on to x = end: it crosses itself
/// in (3, -3, 0) if it gets there.
inline Chain loop(double end) {
  return Chain(std::vector{cylinder(Vec3(3, -5, 0), Vec3(3, 0, 0), 1),
                           elbow(3, 3 * std::numbers::pi / 2, 1),
                           cylinder(Vec3(0, -3, 0), Vec3(end, -3, 0), 1)});
}

}  // namespace dupin::test
