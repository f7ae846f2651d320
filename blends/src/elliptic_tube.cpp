#include "dupin/blends/elliptic_tube.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "dupin/blends/regularity.h"
#include "dupin/kernel/error.h"
#include "quadrature.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

struct Turn {
  double angle = 0, rate = 0;
};

Turn turn_at(const EllipticTube& tube, double t) {
  const double s = 1 - t;
  return tube.continuity == Continuity::g1
             ? Turn{tube.turn * t * t * (3 - 2 * t), tube.turn * 6 * t * s}
             : Turn{tube.turn * t * t * t * (10 - t * (15 - 6 * t)),
                    tube.turn * 30 * t * t * s * s};
}

struct Axes {
  Vec3 first, second;
};

Axes axes_at(const Frame& frame, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * frame.first + s * frame.second, c * frame.second - s * frame.first};
}

Ring circle_about(const EllipticRing& ring) {
  return {ring.center, ring.normal, std::max(ring.first, ring.second)};
}

void validate(const EllipticRing& ring) {
  for (const double radius : {ring.first, ring.second}) {
    validate(Ring{ring.center, ring.normal, radius});
  }
  // As for a ring's normal: typed-in numbers are admitted, and nothing turns by more than that.
  if (!ring.axis.allFinite() || std::abs(ring.axis.norm() - 1) > 1e-9 ||
      std::abs(ring.axis.dot(ring.normal)) > 1e-9) {
    throw Error(Errc::invalid_argument,
                "an elliptic ring's axis must have unit length and be orthogonal to its normal");
  }
}

RadiusLaw radius_between(double from, double to, const CyclicBlendOptions& options) {
  if (options.continuity == Continuity::g2) {
    return BezierRadius{{from, from, from, to, to, to}};
  }
  if (options.radius_law == BlendLaw::r2) {
    return CyclideRadius{from, to};
  }
  return CubicRadius{from, to};
}

// From the frame's first axis to the line along `axis`, in (-pi/2, pi/2].
double shortest_turn(const Frame& frame, const Vec3& axis) {
  const double angle = std::atan2(axis.dot(frame.second), axis.dot(frame.first));
  return angle > kPi / 2 ? angle - kPi : angle <= -kPi / 2 ? angle + kPi : angle;
}

}  // namespace

EllipticRing flipped(const EllipticRing& ring) {
  EllipticRing result = ring;
  result.normal = flipped(Ring{ring.center, ring.normal, ring.first}).normal;
  return result;
}

FrameField frames(const EllipticTube& tube, const FrameOptions& options) {
  return {tube.spine, tube.start.axis, options};
}

// With p = a cos u c1 + b sin u c2: x_t = (v - p.T') T + w, x_u = q, where w is the change of p in
// the turning frame; x_u x x_t = (v - p.T') q x T + q x w.
SurfacePoint evaluate(const EllipticTube& tube, const FrameField& frame_field, double t, double u) {
  const SpinePoint y = evaluate(tube.spine, t);
  const RadiusValue a = evaluate(tube.first, t), b = evaluate(tube.second, t);
  const Frame frame = frame_field.at(t);
  const Turn turn = turn_at(tube, t);
  const auto [c1, c2] = axes_at(frame, turn.angle);
  const double c = std::cos(u), s = std::sin(u), speed = y.first.norm();
  const Vec3 p = a.value * c * c1 + b.value * s * c2;
  const Vec3 q = b.value * c * c2 - a.value * s * c1;
  const Vec3 w =
      a.first * c * c1 + b.first * s * c2 + turn.rate * (a.value * c * c2 - b.value * s * c1);
  const double advance = speed - p.dot(y.second) / speed;
  const Vec3 outward = b.value * c * c1 + a.value * s * c2;  // q x T
  return {y.position + p, advance * frame.tangent + w, q,
          (advance * outward + q.cross(w)).normalized()};
}

double margin_at(const EllipticTube& tube, const FrameField& frame_field, double t) {
  const SpinePoint y = evaluate(tube.spine, t);
  const auto [c1, c2] = axes_at(frame_field.at(t), turn_at(tube, t).angle);
  // c.T' = c.y'' / v for c across T.
  const double extent = std::hypot(evaluate(tube.first, t).value * c1.dot(y.second),
                                   evaluate(tube.second, t).value * c2.dot(y.second));
  return 1 - extent / y.first.squaredNorm();
}

double certified_margin(const EllipticTube& tube) {
  const auto with = [&](const RadiusLaw& radius) {
    return regularity({{}, {}, tube.spine, radius}).lower;
  };
  return std::min(with(tube.first), with(tube.second));
}

double volume(const EllipticTube& tube) {
  return kPi * detail::integral([&](double t) {
           return evaluate(tube.first, t).value * evaluate(tube.second, t).value *
                  evaluate(tube.spine, t).first.norm();
         });
}

EllipticTube elliptic_blend(const EllipticRing& from, const EllipticRing& to,
                            const CyclicBlendOptions& options) {
  validate(from);
  validate(to);
  EllipticTube tube{flipped(from),
                    flipped(to),
                    cyclic_blend(circle_about(from), circle_about(to), options).spine,
                    radius_between(from.first, to.first, options),
                    radius_between(from.second, to.second, options),
                    0,
                    options.continuity};
  if (to.first != to.second) {
    tube.turn = shortest_turn(frames(tube).at(1), to.axis);
  }
  return tube;
}

}  // namespace dupin
