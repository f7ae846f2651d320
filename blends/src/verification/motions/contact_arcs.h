#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <variant>

#include "verification/motions/rolling_balls.h"
#include "verification/motions/taylor_jet.h"

namespace dupin::verification {

template <std::size_t count>
[[nodiscard]] BallJets<count> balls_on(const CanalFillet& loop, const TurnStretch& turn) {
  return std::visit(BallReader<count>(turn), loop.motion);
}

/// The balls on a stretch. Where generators meet a cone depends on the angle in many ways at once,
/// which intervals take for independent: only short stretches would do without Taylor's formula
/// about the middle.
template <std::size_t count>
[[nodiscard]] BallJets<count> balls_around(const CanalFillet& loop, const TurnStretch& middle,
                                           const TurnStretch& all) {
  constexpr std::size_t kMore = count + 4;
  if (!rolls_on_cones(loop)) {
    return balls_on<count>(loop, all);
  }
  const auto here = balls_on<kMore>(loop, middle), everywhere = balls_on<kMore>(loop, all);
  return {by_taylor<count>(here.center, everywhere.center, all.reach),
          by_taylor<count>(here.radius, everywhere.radius, all.reach)};
}

/// What encloses the arcs of a loop of a fillet over a stretch: of the circles in which the balls
/// touch their envelope, the shorter arcs between the places nearest to the feet on both quadrics.
/// With the centre C of the circle, its radius c, the unit normal T (along the ball's velocity) and
/// the unit vectors w from C to the arc, points are x = C + c w; ' is d/dchi.
struct ContactArcs {
  double length = 0;                          ///< at least what chi grows
  Interval ball, speed;                       ///< the ball's radius, |m'|
  IntervalVec tangent, turning;               ///< T, T'
  IntervalVec second_turning;                 ///< T''
  Interval advance, second_advance;           ///< a = C'.T, a'
  Interval lag, second_lag;                   ///< b with C' = a T - b T', b'
  Interval radius, growth, second_growth;     ///< c, c', c''
  std::array<IntervalVec, 2> toward;          ///< w at both feet
  std::array<Interval, 2> spin, spin_change;  ///< how fast it turns about T beyond what T takes
                                              ///< along, and the derivative of that
  Interval cosine;                            ///< of the arc's angle
  Interval inverse_cosine;  ///< 1 to 1 / the cosine of half of it: w = a w1 + b w2 with a + b in it
  Interval bending;         ///< w.T' on all of the arcs
  Interval passing;         ///< x'.T there: a - c w.T'
  /// Of quadrilaterals that hold the arcs: their ends, and where the tangents there meet the one
  /// halfway.
  std::array<IntervalVec, 4> corners;
  IntervalVec middle;  ///< of the points halfway on the arcs
};

/// None where the numbers do not tell, or the balls have no such arcs.
[[nodiscard]] std::optional<ContactArcs> contact_arcs(const CanalFillet& loop,
                                                      const ParameterInterval& t);

/// Encloses w.d for all w.
[[nodiscard]] Interval along_arcs(const ContactArcs& arcs, const IntervalVec& d);

/// An upper bound of x.d.
[[nodiscard]] double furthest(const ContactArcs& arcs, const IntervalVec& d);

/// Where arcs shrink to points and turn at once: two equal pipes, or one that touches the other
/// from inside. t is 0 or 1; 2 is 0 again.
[[nodiscard]] bool has_corner(const CanalFillet& loop, double t);

/// The outward unit normal of a quadric's parallel surface at a moving point, and how far that is
/// from the quadric. A quadric is the cone or cylinder that its ring belongs to.
template <std::size_t count>
struct QuadricJets {
  JetVec<count> normal;
  Jet<count> distance;
};

template <std::size_t count>
[[nodiscard]] QuadricJets<count> seen_from(const Ring& quadric, const JetVec<count>& point) {
  const IntervalVec stored = interval_vec(quadric.normal);
  const IntervalVec axis = (Interval(1) / numbers::norm(stored)) * stored;
  const auto fixed = [](const IntervalVec& v) {
    return JetVec<count>{constant<count>(v[0]), constant<count>(v[1]), constant<count>(v[2])};
  };
  const Interval slope = quadric.slope;
  const Interval slant = sqrt(Interval(1) + square(slope));
  const JetVec<count> from = point - fixed(interval_vec(quadric.center));
  const Jet<count> height = dot(from, axis);
  const JetVec<count> arm = from - height * axis;
  const Jet<count> reach = sqrt(squared_norm(arm));
  const Interval scale = Interval(1) / slant;
  return {scale * (arm / reach - fixed(slope * axis)),
          scale * (reach - constant<count>(quadric.radius) - slope * height)};
}

}  // namespace dupin::verification
