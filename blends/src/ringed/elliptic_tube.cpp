#include "dupin/blends/elliptic_tube.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "dupin/blends/regularity.h"
#include "dupin/kernel/error.h"
#include "numbers/quadrature.h"
#include "ringed/second_derivatives.h"

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

// From the frame's first axis to the line along `axis`, in (-pi/2, pi/2].
double shortest_turn(const Frame& frame, const Vec3& axis) {
  const double angle = std::atan2(axis.dot(frame.second), axis.dot(frame.first));
  return angle > kPi / 2 ? angle - kPi : angle <= -kPi / 2 ? angle + kPi : angle;
}

}  // namespace

FrameField frames(const EllipticTube& tube, const FrameOptions& options) {
  return {tube.spine, tube.axis, options};
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
  return kPi * numbers::integral([&](double t) {
           return evaluate(tube.first, t).value * evaluate(tube.second, t).value *
                  evaluate(tube.spine, t).first.norm();
         });
}

namespace {

// The rate of a semi-axis per advance of the spine, less the slope that its ring has: the greatest
// absolute value where the advance lies in `advance`.
double slope_excess(const RadiusLaw& law, double t, double slope,
                    const numbers::Interval& advance) {
  const double rate = evaluate(law, t).first;
  if (rate == 0 && slope == 0) {
    return 0;
  }
  return (numbers::Interval(rate) / advance - slope).magnitude();
}

}  // namespace

// The tube's normal at the end is parallel to q x T + q x w / advance with advance = v - p.T' and w
// the rates of the semi-axes, that of the ruled surface to q x T + q x s with the slopes s. As q x
// T is as long as q and at right angles to both q x w and q x s, the angle's sine is at most
// |w / advance - s|, and the angle at most pi / 2 times that.
double tangency_bound(const EllipticTube& tube, End end) {
  const double t = end == End::start ? 0 : 1, outward = end == End::start ? -1 : 1;
  const Ring& ring = end == End::start ? tube.start : tube.end;
  const auto y = ringed::spine_bounds(tube.spine, t);
  const numbers::Interval bend = numbers::Interval(largest_radius(ring)) * y.turning;
  const numbers::Interval advance{(y.speed - bend).lower, (y.speed + bend).upper};
  if (!(advance.lower > 0)) {
    throw Error(Errc::irregular_surface, "the tube folds there", {},
                end == End::start ? "start" : "end");
  }
  const double first = slope_excess(tube.first, t, outward * ring.slope, advance);
  const double second = slope_excess(tube.second, t, outward * across_slope(ring), advance);
  return kPi / 2 * std::hypot(first, second);
}

EllipticTube elliptic_tube(const Ring& start, const Ring& end, const Spine& spine,
                           const RadiusLaw& first, const RadiusLaw& second, Continuity continuity) {
  EllipticTube tube{start, end, spine, first, second, reference_axis(start), 0, continuity};
  if (end.ellipse) {
    const double turn = shortest_turn(frames(tube).at(1), end.ellipse->axis);
    if (start.ellipse) {
      tube.turn = turn;
    } else {
      // A frame that starts turned arrives turned by as much.
      tube.axis = axes_at(frames(tube).at(0), turn).first;
    }
  }
  return tube;
}

}  // namespace dupin
