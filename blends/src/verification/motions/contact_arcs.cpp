#include "verification/motions/contact_arcs.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <variant>

#include "verification/work.h"

namespace dupin::verification {
namespace {

using numbers::cross;
using numbers::dot;

constexpr std::uint64_t kArcWork = 64;  // of the products and roots of jets

// What is asked for, with one derivative more.
struct ArcJets {
  Jet<4> ball, speed, radius, behind, cosine;
  JetVec<4> tangent;
  Jet<3> ahead;
  std::array<JetVec<4>, 2> toward;
  std::array<Jet<3>, 2> spin, bending, passing;
  std::array<JetVec<4>, 4> corners;
  JetVec<4> middle;
};

constexpr std::size_t kOrders = 5;

std::optional<ArcJets> arc_jets(const CanalFillet& loop, const BallJets<kOrders>& balls) {
  const JetVec<4> velocity = derivative(balls.center), center = shortened<4>(balls.center);
  const Jet<4> squared = squared_norm(velocity), growth = derivative(balls.radius);
  if (!(balls.radius[0].lower > 0 && (squared[0] - square(growth[0])).lower > 0)) {
    return std::nullopt;
  }
  ArcJets jets;
  jets.ball = shortened<4>(balls.radius);
  jets.speed = sqrt(squared);
  jets.tangent = velocity / jets.speed;
  // The circle is behind the ball's centre where the ball grows.
  const Jet<4> sine = growth / jets.speed;
  jets.radius = jets.ball * sqrt(constant<4>(1) - square(sine));
  jets.behind = jets.ball * sine;
  jets.ahead = shortened<3>(jets.speed) - derivative(jets.behind);
  const JetVec<3> tangent = shortened<3>(jets.tangent), turning = derivative(jets.tangent);
  for (std::size_t i = 0; i < 2; ++i) {
    const JetVec<4> normal = seen_from(loop.quadrics.at(i), center).normal;
    const JetVec<4> across = dot(normal, jets.tangent) * jets.tangent - normal;
    const Jet<4> length = squared_norm(across);
    if (!(length[0].lower > 0)) {
      return std::nullopt;
    }
    jets.toward.at(i) = across / sqrt(length);
    const JetVec<3> toward = shortened<3>(jets.toward.at(i));
    jets.spin.at(i) = dot(derivative(jets.toward.at(i)), verification::cross(tangent, toward));
    jets.bending.at(i) = dot(toward, turning);
    jets.passing.at(i) = jets.ahead - shortened<3>(jets.radius) * jets.bending.at(i);
  }
  jets.cosine = dot(jets.toward[0], jets.toward[1]);
  const JetVec<4> sum = jets.toward[0] + jets.toward[1];
  const Jet<4> squared_sum = squared_norm(sum);
  if (!(squared_sum[0].lower > 0)) {
    return std::nullopt;
  }
  const JetVec<4> center_of_circle = center - jets.behind * jets.tangent;
  const JetVec<4> halfway = sum / sqrt(squared_sum);
  jets.middle = center_of_circle + jets.radius * halfway;
  for (std::size_t i = 0; i < 2; ++i) {
    const JetVec<4>& end = jets.toward.at(i);
    const Jet<4> reach = jets.radius / (constant<4>(1) + dot(end, halfway));
    jets.corners.at(i) = center_of_circle + jets.radius * end;
    jets.corners.at(2 + i) = center_of_circle + reach * (end + halfway);
  }
  return jets;
}

// Enclosures over a stretch, by the mean value theorem where that is better.
class Enclosures {
 public:
  Enclosures(const ArcJets& middle, const ArcJets& all, double reach)
      : middle_(middle), all_(all), reach_(-reach, reach) {}

  template <class Member>
  [[nodiscard]] auto operator()(const Member& member, std::size_t order = 0) const {
    return enclosed(member(middle_), member(all_), order);
  }

 private:
  template <std::size_t count>
  [[nodiscard]] Interval enclosed(const Jet<count>& at, const Jet<count>& all,
                                  std::size_t order) const {
    return intersection(at[order] + reach_ * all[order + 1], all[order]);
  }
  template <std::size_t count>
  [[nodiscard]] IntervalVec enclosed(const JetVec<count>& at, const JetVec<count>& all,
                                     std::size_t order) const {
    return {enclosed(at[0], all[0], order), enclosed(at[1], all[1], order),
            enclosed(at[2], all[2], order)};
  }

  const ArcJets &middle_, &all_;
  Interval reach_;
};

// The greatest w.d, of what it is at both ends: it is in an arc's inside only if d, seen in its
// plane, points into it.
double highest(const ContactArcs& arcs, const std::array<Interval, 2>& ends, double length) {
  const double most = std::max(ends[0].upper, ends[1].upper);
  for (std::size_t i = 0; i < 2; ++i) {
    if ((ends.at(i) - arcs.cosine * ends.at(1 - i)).upper <= 0) {
      return most;
    }
  }
  const double wide = most > 0 ? (Interval(most) * arcs.inverse_cosine.upper).upper : most;
  return std::min(wide, length);
}

Interval between(const ContactArcs& arcs, const std::array<Interval, 2>& ends, double length) {
  return {-highest(arcs, {-ends[0], -ends[1]}, length), highest(arcs, ends, length)};
}

// Inside of the arcs it is less than at the ends only if w.T' is more there.
Interval passing(const ContactArcs& arcs, const std::array<Interval, 2>& bending,
                 const std::array<Interval, 2>& ends) {
  const Interval inside = arcs.advance - arcs.radius * arcs.bending;
  const bool falls = arcs.bending.upper > std::max(bending[0].upper, bending[1].upper);
  return {falls ? inside.lower : hull(ends[0], ends[1]).lower, inside.upper};
}

}  // namespace

Interval along_arcs(const ContactArcs& arcs, const IntervalVec& d) {
  return between(arcs, {dot(arcs.toward[0], d), dot(arcs.toward[1], d)}, numbers::norm(d).upper);
}

double furthest(const ContactArcs& arcs, const IntervalVec& d) {
  double most = -std::numeric_limits<double>::infinity();
  for (const IntervalVec& corner : arcs.corners) {
    most = std::max(most, dot(corner, d).upper);
  }
  return most;
}

bool has_corner(const CanalFillet& loop, double t) {
  const auto* through = std::get_if<RollingThrough>(&loop.motion);
  return through != nullptr && (t == 1 ? through->below : through->above) == 0;
}

std::optional<ContactArcs> contact_arcs(const CanalFillet& loop, const ParameterInterval& t) {
  const double at = std::midpoint(t.from, t.to);
  const auto turn = turn_stretch(t), middle_turn = turn_stretch({at, at});
  if (!turn || !middle_turn) {
    return std::nullopt;
  }
  spend(rolls_on_cones(loop) ? kArcWork + kConeWork : kArcWork);
  const auto all = arc_jets(loop, balls_around<kOrders>(loop, *middle_turn, *turn)),
             middle = arc_jets(loop, balls_on<kOrders>(loop, *middle_turn));
  if (!all || !middle) {
    return std::nullopt;
  }
  const Enclosures over(*middle, *all, turn->reach);
  ContactArcs arcs;
  arcs.length = turn->length;
  arcs.ball = over([](const ArcJets& j) { return j.ball; });
  arcs.speed = over([](const ArcJets& j) { return j.speed; });
  const auto tangent = [](const ArcJets& j) { return j.tangent; };
  arcs.tangent = over(tangent);
  arcs.turning = over(tangent, 1);
  arcs.second_turning = over(tangent, 2);
  const auto ahead = [](const ArcJets& j) { return j.ahead; };
  arcs.advance = over(ahead);
  arcs.second_advance = over(ahead, 1);
  const auto behind = [](const ArcJets& j) { return j.behind; };
  arcs.lag = over(behind);
  arcs.second_lag = over(behind, 1);
  const auto radius = [](const ArcJets& j) { return j.radius; };
  arcs.radius = over(radius);
  arcs.growth = over(radius, 1);
  arcs.second_growth = over(radius, 2);
  std::array<Interval, 2> bending, ends;
  for (std::size_t i = 0; i < 2; ++i) {
    arcs.toward.at(i) = over([i](const ArcJets& j) { return j.toward.at(i); });
    const auto spin = [i](const ArcJets& j) { return j.spin.at(i); };
    arcs.spin.at(i) = over(spin);
    arcs.spin_change.at(i) = over(spin, 1);
    bending.at(i) = over([i](const ArcJets& j) { return j.bending.at(i); });
    ends.at(i) = over([i](const ArcJets& j) { return j.passing.at(i); });
  }
  for (std::size_t i = 0; i < arcs.corners.size(); ++i) {
    arcs.corners.at(i) = over([i](const ArcJets& j) { return j.corners.at(i); });
  }
  arcs.middle = over([](const ArcJets& j) { return j.middle; });
  arcs.cosine = over([](const ArcJets& j) { return j.cosine; });
  arcs.inverse_cosine = hull(1, sqrt(Interval(2) / (Interval(1) + arcs.cosine)));
  arcs.bending = between(arcs, bending, numbers::norm(arcs.turning).upper);
  arcs.passing = passing(arcs, bending, ends);
  return arcs;
}

}  // namespace dupin::verification
