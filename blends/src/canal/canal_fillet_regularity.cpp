#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>
#include <variant>
#include <vector>

#include "canal/ball_on_cylinders.h"
#include "canal/stretch.h"
#include "dupin/blends/canal_fillet.h"

namespace dupin {
namespace {

using canal::BallJet;
using numbers::Interval;
using numbers::IntervalVec;

constexpr std::size_t kMostLeaves = 4000;
constexpr double kShare = 0.9;  // of the least sampled value, at which the bound is good enough

/// The outward normal where the ball touches a quadric from outside.
IntervalVec normal_at_foot(const Ring& quadric, const IntervalVec& center, const Interval& radius) {
  const PeVector sphere = contact_sphere(quadric), along = contact_tangent(quadric);
  const IntervalVec axis = numbers::interval_vec(along.m);
  const IntervalVec to_ball = center - numbers::interval_vec(sphere.m);
  const Interval reach = radius + sphere.r;
  const Interval shift = dot(to_ball, axis) + reach * along.r;
  return (Interval(1) / (reach + shift * along.r)) * (to_ball - shift * axis);
}

/// Enclosures for all parameters of an interval.
struct Bounds {
  Interval regularity, radius;

  [[nodiscard]] bool proved() const { return regularity.lower > 0 && radius.lower > 0; }
  [[nodiscard]] bool refuted() const { return regularity.upper <= 0 || radius.upper <= 0; }
};

/// Of `least_regularity` and the radius. Where the ball grows as fast as it moves, none of it is
/// regular.
Bounds bounds(const CanalFillet& fillet, const ParameterInterval& at) {
  constexpr std::size_t kOrders = 4;  // more narrow the stretches by less than they take
  const bool on_cylinders = std::holds_alternative<RollingThrough>(fillet.motion) ||
                            std::holds_alternative<RollingPartly>(fillet.motion);
  const BallJet<canal::Jet<Interval>> ball =
      on_cylinders ? canal::balls(fillet, at) : canal::balls_by_series<kOrders>(fillet, at);
  const auto& [x, y, z] = ball.center;
  const IntervalVec center{x.value, y.value, z.value}, velocity{x.rate, y.rate, z.rate};
  const IntervalVec bend{x.acceleration, y.acceleration, z.acceleration};
  const Interval radius = ball.radius.value, rate = ball.radius.rate;
  const Interval speed_squared = square(velocity[0]) + square(velocity[1]) + square(velocity[2]);
  const Interval envelops = speed_squared - square(rate);
  if (!(envelops.lower > 0)) {
    return {Interval(Interval::whole().lower, envelops.upper <= 0 ? 0 : Interval::whole().upper),
            radius};
  }
  // What the regularity is less than 1 by, times the speed's square, where the arc goes straight.
  const Interval constant = square(rate) + radius * ball.radius.acceleration;
  std::array<IntervalVec, 2> normals;
  std::array<Interval, 2> ends, turns;
  for (std::size_t i = 0; i < 2; ++i) {
    normals[i] = normal_at_foot(fillet.quadrics[i], center, radius);
    ends[i] = constant - radius * dot(bend, normals[i]);
    turns[i] = dot(cross(velocity, normals[i]), bend);
  }
  Interval most = max(ends[0], ends[1]);
  // The least is inside the arc only if it falls at the first foot and rises at the second, as one
  // goes along the arc, whose sense is the sign of the normals' determinant with the velocity.
  const Interval sense = dot(cross(velocity, normals[0]), normals[1]);
  bool possible = false, certain = true;
  for (const double sign : {1.0, -1.0}) {
    const Interval first = Interval(sign) * turns[0], second = Interval(sign) * turns[1];
    const bool here = (Interval(sign) * sense).upper >= 0;
    possible = possible || (here && first.lower <= 0 && second.upper >= 0);
    certain = certain && (!here || (first.upper < 0 && second.lower > 0));
  }
  if (possible) {
    const Interval lag = rate / sqrt(speed_squared);
    const Interval valley = constant - radius * rate * dot(bend, velocity) / speed_squared +
                            radius * sqrt(Interval(1) - square(lag)) * norm(cross(bend, velocity)) /
                                sqrt(speed_squared);
    most = {certain ? std::max(most.lower, valley.lower) : most.lower,
            std::max(most.upper, valley.upper)};
  }
  return {Interval(1) - most / speed_squared, radius};
}

struct Leaf {
  ParameterInterval at;
  Bounds bounds;

  [[nodiscard]] double worth() const {
    return bounds.radius.lower > 0 ? bounds.regularity.lower : Interval::whole().lower;
  }
  friend bool operator<(const Leaf& a, const Leaf& b) { return a.worth() > b.worth(); }
};

CanalRegularity conclusion(std::priority_queue<Leaf> leaves, Verdict verdict) {
  CanalRegularity result{verdict, leaves.top().bounds.regularity.lower,
                         leaves.top().bounds.radius.lower, leaves.top().at, leaves.size()};
  for (; !leaves.empty(); leaves.pop()) {
    result.radius = std::min(result.radius, leaves.top().bounds.radius.lower);
  }
  return result;
}

CanalRegularity refuted(const Bounds& point, double parameter, std::size_t leaves) {
  return {
      Verdict::refuted, point.regularity.upper, point.radius.upper, {parameter, parameter}, leaves};
}

double middle_of(const ParameterInterval& at) { return at.from + (at.to - at.from) / 2; }

/// Where bounds are lowest need not be where it folds: all other places are looked at before it is
/// left undecided.
template <class BoundsAt>
CanalRegularity last_looks(const std::priority_queue<Leaf>& leaves, const BoundsAt& bounds_at) {
  for (auto rest = leaves; !rest.empty(); rest.pop()) {
    const double place = middle_of(rest.top().at);
    if (!rest.top().bounds.proved()) {
      const Bounds point = bounds_at(ParameterInterval{place, place});
      if (point.refuted()) {
        return refuted(point, place, leaves.size());
      }
    }
  }
  return conclusion(leaves, Verdict::undecided);
}

/// By halving where the bound is lowest.
template <class BoundsAt>
CanalRegularity search(const BoundsAt& bounds_at) {
  std::priority_queue<Leaf> leaves;
  const auto add = [&](double from, double to) {
    leaves.push({{from, to}, bounds_at(ParameterInterval{from, to})});
  };
  for (int quarter = -2; quarter < 2; ++quarter) {
    add(quarter * std::numbers::pi / 2, (quarter + 1) * std::numbers::pi / 2);
  }
  double sampled = std::numeric_limits<double>::infinity();
  double shortest = std::numeric_limits<double>::infinity();  // of the proved leaves looked into
  while (true) {
    const Leaf worst = leaves.top();
    const double length = worst.at.to - worst.at.from, middle = middle_of(worst.at);
    const bool proved = worst.bounds.proved();
    if (!proved || length < shortest) {
      const Bounds point = bounds_at(ParameterInterval{middle, middle});
      if (point.refuted()) {
        return refuted(point, middle, leaves.size());
      }
      sampled = std::min(sampled, point.regularity.upper);
      shortest = proved ? length : shortest;
    }
    if (proved && worst.bounds.regularity.lower >= kShare * sampled) {
      return conclusion(std::move(leaves), Verdict::proved);
    }
    if (leaves.size() >= kMostLeaves || !(worst.at.from < middle && middle < worst.at.to)) {
      return proved ? conclusion(std::move(leaves), Verdict::proved)
                    : last_looks(leaves, bounds_at);
    }
    leaves.pop();
    add(worst.at.from, middle);
    add(middle, worst.at.to);
  }
}

}  // namespace

CanalRegularity prove_regular(const CanalFillet& fillet) {
  if (const auto ball = canal::BallOnCylinders::of(fillet)) {
    const CanalRegularity quick = search([&](const ParameterInterval& at) {
      return Bounds{ball->least_regularity(at), ball->radius()};
    });
    if (quick.verdict != Verdict::undecided && quick.leaves < kMostLeaves) {
      return quick;
    }
  }
  return search([&](const ParameterInterval& at) { return bounds(fillet, at); });
}

}  // namespace dupin
