#include "canal/rolling_ball.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "canal/quadric_pair.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

/// Two skew or crossing axes: origin of the first one nearest to the second, and how far it lies
/// over that in the direction `up`.
struct CrossedAxes {
  Vec3 origin, along, across, up;
  double cosine = 0, sine = 1, height = 0;
  double reach = 0;  ///< of the centres from each other
};

CrossedAxes crossed(const Ring& first, const Ring& second) {
  constexpr double kParallel = 1e-9;  // the loop would be longer than the pipes by its inverse
  const Vec3 a = first.normal.normalized(), b = second.normal.normalized();
  const Vec3 product = a.cross(b), apart = second.center - first.center;
  const double sine = product.norm();
  if (!(sine > kParallel)) {
    throw Error(Errc::irregular_surface,
                "a ball on two cylinders with parallel axes runs along them and closes no loop");
  }
  CrossedAxes axes;
  axes.along = a;
  axes.up = product / sine;
  axes.across = axes.up.cross(a);
  axes.cosine = a.dot(b);
  axes.sine = sine;
  axes.origin = first.center + apart.cross(b).dot(axes.up) / sine * a;
  axes.height = -apart.dot(axes.up);
  axes.reach = apart.norm();
  return axes;
}

/// Zero where it is zero within `limit`.
double settled(double x, double limit) { return std::abs(x) <= limit ? 0 : x; }

RollingThrough through(const Ring& thicker, const CrossedAxes& axes, double passing, double radius,
                       double side, double touching) {
  RollingThrough motion{axes.origin,      axes.along,  axes.across, axes.up, axes.cosine, axes.sine,
                        passing + radius, axes.height, 0,           0,       side,        radius};
  const double difference = thicker.radius - passing;
  const double limit = touching * (thicker.radius + axes.reach);
  motion.below = settled(difference + axes.height, limit);
  motion.above = settled(difference - axes.height, limit);
  return motion;
}

RollingPartly partly(const std::array<Ring, 2>& cylinders, double radius) {
  // The first one is the upper one, if need be seen from the other end of the second axis.
  CrossedAxes axes = crossed(cylinders[0], cylinders[1]);
  if (axes.height < 0) {
    axes = crossed(cylinders[0], flipped(cylinders[1]));
  }
  const double difference = cylinders[0].radius - cylinders[1].radius;
  const double sum = cylinders[0].radius + cylinders[1].radius;
  if (!(axes.height < sum)) {
    throw Error(Errc::irregular_surface, "no edge for a ball to roll along: the axes are " +
                                             decimal(axes.height, kMessageDigits) +
                                             " apart, and the radii are " +
                                             decimal(sum, kMessageDigits) + " together");
  }
  return {axes.origin,
          axes.along,
          axes.across,
          axes.up,
          axes.cosine,
          axes.sine,
          cylinders[0].radius + radius,
          sum - axes.height + 2 * radius,
          axes.height + difference,
          axes.height - difference,
          radius};
}

/// The ring of the parallel quadric at a distance, on which balls of that radius have their
/// centres.
Ring parallel(Ring ring, double distance) {
  ring.normal.normalize();
  ring.radius += distance * std::hypot(1, ring.slope);
  return ring;
}

/// Why the balls do not touch the wanted nappes along a closed and regular loop, if they do not.
std::optional<std::string> fault_of(const CanalFillet& fillet) {
  for (int k = 0; k < 128; ++k) {
    // Not numbers where the generator misses the other quadric.
    const MovingBall at = ball(fillet, 2 * std::numbers::pi * k / 128);
    if (!at.center.allFinite()) {
      return "neither quadric passes through the other: the ball closes no loop";
    }
    const ContactArc arc = contact_arc(fillet.quadrics, at);
    for (std::size_t i = 0; i < 2; ++i) {
      const Ring& ring = fillet.quadrics[i];
      if (!(ring.radius + ring.slope * (arc.feet[i] - ring.center).dot(ring.normal) > 0)) {
        return "the ball runs beyond the apex of a cone before it has closed a loop";
      }
    }
  }
  return std::nullopt;
}

/// The loops of both sides, or those of them that are closed on the wanted nappes.
std::vector<CanalFillet> on_generators(const std::array<Ring, 2>& quadrics, std::size_t one,
                                       double radius, bool all) {
  const Ring first = parallel(quadrics[one], radius), second = parallel(quadrics[1 - one], radius);
  const CrossedAxes axes = crossed(first, second);
  std::vector<CanalFillet> fillets;
  for (const double side : {1.0, -1.0}) {
    CanalFillet fillet{quadrics, RollingOnCones{first, second, second.normal.cross(axes.up),
                                                axes.up, side, radius}};
    const auto fault = fault_of(fillet);
    if (fault && all) {
      throw Error(Errc::irregular_surface, *fault);
    }
    if (!fault) {
      fillets.push_back(std::move(fillet));
    }
  }
  return fillets;
}

using Polynomial = std::array<long double, 9>;  // from the constant on

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial result{};
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; i + j < a.size(); ++j) {
      result[i + j] += a[i] * b[j];
    }
  }
  return result;
}

Polynomial operator*(long double s, Polynomial a) {
  std::ranges::for_each(a, [s](long double& x) { x *= s; });
  return a;
}

Polynomial operator+(Polynomial a, const Polynomial& b) {
  std::ranges::transform(a, b, a.begin(), std::plus());
  return a;
}

using PolynomialVec = std::array<Polynomial, 3>;

Polynomial product(const PolynomialVec& a, const PolynomialVec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A point of a generator, or its direction, by cos, times 1 + q^2 for q = width cos.
PolynomialVec around(const RollingPartlyOnCones& motion, const Vec3& along, double size) {
  const long double w = motion.width;
  const Polynomial plus{1, 0, w * w}, minus{1, 0, -w * w}, twice{0, 2 * w};
  PolynomialVec result;
  for (int k = 0; k < 3; ++k) {
    result.at(std::size_t(k)) =
        (size * motion.zero[k]) * minus + (size * motion.quarter[k]) * twice + along[k] * plus;
  }
  return result;
}

// Of the squared half of a generator's way through the first quadric, less what vanishes at its
// ends: the discriminant divided by 1 - cos^2.
std::array<double, 7> rest_of(const RollingPartlyOnCones& motion) {
  const Ring &one = motion.first, &two = motion.second;
  const PolynomialVec start = around(motion, two.center - one.center, two.radius),
                      ahead = around(motion, two.normal, two.slope);
  const Polynomial n[] = {{one.normal.x()}, {one.normal.y()}, {one.normal.z()}};
  const PolynomialVec normal{n[0], n[1], n[2]};
  const long double w = motion.width, slope = one.slope, radius = one.radius;
  const Polynomial all{1, 0, w * w}, s0 = product(start, normal), s1 = product(ahead, normal);
  const long double stretch = 1 + slope * slope, lever = radius * slope;
  const Polynomial a = product(ahead, ahead) + -stretch * (s1 * s1);
  const Polynomial b = product(start, ahead) + -stretch * (s0 * s1) + -lever * (s1 * all);
  const Polynomial c = product(start, start) + -stretch * (s0 * s0) + -2 * lever * (s0 * all) +
                       -(radius * radius) * (all * all);
  const Polynomial discriminant = b * b + -1 * (a * c);
  std::array<double, 7> rest{};
  std::array<long double, 2> before{};
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const long double next = discriminant[i] + before[i % 2];
    before[i % 2] = next;
    rest[i] = double(next);
  }
  return rest;
}

// Positive where the generator at an angle meets the first quadric.
double discriminant(const Ring& one, const Ring& two, const Vec3& direction) {
  const Vec3 start = two.center - one.center + two.radius * direction,
             ahead = two.normal + two.slope * direction;
  const double s0 = start.dot(one.normal), s1 = ahead.dot(one.normal);
  const double stretch = 1 + one.slope * one.slope, lever = one.radius * one.slope;
  const double a = ahead.squaredNorm() - stretch * s1 * s1;
  const double b = start.dot(ahead) - stretch * s0 * s1 - lever * s1;
  const double c =
      start.squaredNorm() - stretch * s0 * s0 - 2 * lever * s0 - one.radius * one.radius;
  return b * b - a * c;
}

// None unless the generators of the second that meet the first are side by side.
std::optional<RollingPartlyOnCones> partly_on(const Ring& first, const Ring& second,
                                              double radius) {
  constexpr int kAngles = 1024;
  const Vec3 up = crossed(first, second).up, zero = second.normal.cross(up);
  const auto is_met = [&](double angle) {
    return discriminant(first, second, std::cos(angle) * zero + std::sin(angle) * up) > 0;
  };
  std::vector<double> begins, ends;
  for (int i = 0; i < kAngles; ++i) {
    double out = 2 * std::numbers::pi * i / kAngles, in = 2 * std::numbers::pi * (i + 1) / kAngles;
    const bool begins_here = is_met(in);
    if (is_met(out) == begins_here) {
      continue;
    }
    if (!begins_here) {
      std::swap(out, in);
    }
    for (int k = 0; k < 60; ++k) {
      const double half = std::midpoint(out, in);
      (is_met(half) ? in : out) = half;
    }
    (begins_here ? begins : ends).push_back(in);
  }
  if (begins.size() != 1 || ends.size() != 1) {
    return std::nullopt;
  }
  const double end = ends.front() + (ends.front() < begins.front() ? 2 * std::numbers::pi : 0);
  const double middle = std::midpoint(begins.front(), end);
  RollingPartlyOnCones motion;
  motion.first = first;
  motion.second = second;
  motion.zero = std::cos(middle) * zero + std::sin(middle) * up;
  motion.quarter = std::cos(middle) * up - std::sin(middle) * zero;
  motion.width = std::tan((end - begins.front()) / 4);
  motion.radius = radius;
  motion.rest = rest_of(motion);
  return motion;
}

std::vector<CanalFillet> on_cones(const std::array<Ring, 2>& quadrics, double radius) {
  constexpr double kTouching = 1e-9;  // a smaller gap is lost in the rounding of the discriminant
  const canal::QuadricPair pair = canal::quadric_pair(quadrics);
  const double touch = kTouching * (std::abs(pair.nearest[0].r) + std::abs(pair.nearest[1].r));
  const double distance = pair.apart.m.norm(), difference = std::abs(pair.apart.r);
  if (!(pair.squared_sine > 0)) {
    for (const std::size_t one : {0U, 1U}) {
      if (auto fillets = on_generators(quadrics, one, radius, false); !fillets.empty()) {
        return fillets;
      }
    }
    throw Error(Errc::irregular_surface,
                "the ball closes no loop: the slopes are too large for the angle between the axes");
  }
  if (std::abs(distance - difference) <= touch) {
    throw Error(Errc::irregular_surface,
                "one touches the other from inside, or nearly: their inscribed spheres differ by " +
                    decimal(difference, kMessageDigits) + " at a distance of " +
                    decimal(distance, kMessageDigits) +
                    ", which has to be larger or smaller by more than " +
                    decimal(touch, kMessageDigits));
  }
  if (pair.squared_distance < 0) {
    return on_generators(quadrics, pair.apart.r > 0 ? 0 : 1, radius, true);
  }
  const std::array<Ring, 2> centers{parallel(quadrics[0], radius), parallel(quadrics[1], radius)};
  // Of a quadric that all but touches the other from inside, all but all generators meet that.
  std::optional<RollingPartlyOnCones> narrower;
  for (const std::size_t one : {0U, 1U}) {
    const auto motion = partly_on(centers.at(one), centers.at(1 - one), radius);
    if (motion && (!narrower || motion->width < narrower->width)) {
      narrower = motion;
    }
  }
  if (narrower) {
    CanalFillet fillet{quadrics, *narrower};
    if (const auto fault = fault_of(fillet)) {
      throw Error(Errc::irregular_surface, *fault);
    }
    return {std::move(fillet)};
  }
  throw Error(Errc::irregular_surface,
              "neither quadric passes through the other, nor does either close a loop beside it");
}

}  // namespace

std::vector<CanalFillet> rolling_ball_fillets(const std::array<Ring, 2>& quadrics, double radius,
                                              double touching) {
  canal::require_quadrics(quadrics);
  if (radius != 0) {
    canal::require_positive(radius);
  }
  if (!(touching >= 0 && std::isfinite(touching))) {
    throw Error(Errc::invalid_argument,
                "what counts as touching must be finite and not negative, not " +
                    decimal(touching, kMessageDigits));
  }
  if (quadrics[0].slope != 0 || quadrics[1].slope != 0) {
    return on_cones(quadrics, radius);
  }
  const std::size_t thick = quadrics[0].radius < quadrics[1].radius ? 1 : 0;
  const Ring &thicker = quadrics[thick], &thinner = quadrics[1 - thick];
  const CrossedAxes axes = crossed(thicker, thinner);
  const RollingThrough motion = through(thicker, axes, thinner.radius, radius, 1, touching);
  if (motion.below < 0 || motion.above < 0) {
    return {{quadrics, partly(quadrics, radius)}};
  }
  return {{quadrics, motion},
          {quadrics, through(thicker, axes, thinner.radius, radius, -1, touching)}};
}

}  // namespace dupin
