#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "support/fillet_loops.h"
#include "verification/motions/contact_arcs.h"

namespace dupin::verification {
namespace {

using test::holds;

const std::vector<ParameterInterval> kStretches{{0.125, 0.126953125},
                                                {0.5, 0.5},
                                                {0.75, 0.751953125},
                                                {1.25, 1.251953125},
                                                {1.875, 1.876953125}};

std::array<double, 3> places(const ParameterInterval& t) {
  return {t.from, (t.from + t.to) / 2, t.to};
}

// Feet, circles, regularity and the frame's turning are those of the evaluator and its differences.
TEST(ContactArcs, hold_the_arcs_of_all_motions) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    for (const ParameterInterval& t : kStretches) {
      const auto arcs = contact_arcs(loop, t);
      ASSERT_TRUE(arcs) << name;
      for (const double at : places(t)) {
        const double chi = test::angle_at(at), h = 1e-5;
        const MovingBall now = ball(loop, chi);
        const ContactArc arc = contact_arc(loop.quadrics, now);
        const Vec3 other = std::cos(arc.angle) * arc.to_first + std::sin(arc.angle) * arc.across;
        const Vec3 tangent = now.velocity.normalized();
        const Vec3 turning = (ball(loop, chi + h).velocity.normalized() -
                              ball(loop, chi - h).velocity.normalized()) /
                             (2 * h);
        EXPECT_TRUE(holds(arcs->tangent, tangent, 1e-12)) << name << " " << at;
        EXPECT_TRUE(holds(arcs->turning, turning, 1e-8)) << name << " " << at;
        EXPECT_TRUE(holds(arcs->radius, arc.radius, 1e-12)) << name << " " << at;
        EXPECT_TRUE(holds(arcs->toward[0], arc.to_first, 1e-11)) << name << " " << at;
        EXPECT_TRUE(holds(arcs->toward[1], other, 1e-11)) << name << " " << at;
        EXPECT_TRUE(holds(arcs->cosine, std::cos(arc.angle), 1e-11)) << name << " " << at;
        EXPECT_TRUE(holds(arcs->corners[0], arc.feet[0], 1e-11)) << name << " " << at;
        EXPECT_TRUE(holds(arcs->corners[1], arc.feet[1], 1e-11)) << name << " " << at;
        EXPECT_LE(arcs->passing.lower, least_regularity(now, arc) * now.velocity.norm() + 1e-10)
            << name << " " << at;
        if (t.from == t.to) {
          EXPECT_NEAR(arcs->passing.lower, least_regularity(now, arc) * now.velocity.norm(), 1e-9)
              << name;
        }
      }
    }
  }
}

// Of points of the arcs: d/dchi, the second derivatives' parts, and what holds them.
TEST(ContactArcs, hold_how_points_move) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    for (const ParameterInterval& t : kStretches) {
      const auto arcs = contact_arcs(loop, t);
      ASSERT_TRUE(arcs) << name;
      const auto at_share = [&](double chi, double u) {
        const ContactArc arc = contact_arc(loop.quadrics, ball(loop, chi));
        return point(arc, u * arc.angle);
      };
      for (const double at : places(t)) {
        for (const double u : {0.0, 0.3, 1.0}) {
          const double chi = test::angle_at(at), h = 1e-4;
          const Vec3 x = at_share(chi, u);
          const Vec3 rate = (at_share(chi + h, u) - at_share(chi - h, u)) / (2 * h);
          const ContactArc arc = contact_arc(loop.quadrics, ball(loop, chi));
          const Vec3 w = (x - arc.center).normalized();
          const Vec3 tangent = ball(loop, chi).velocity.normalized(), b = tangent.cross(w);
          EXPECT_TRUE(holds(arcs->passing, rate.dot(tangent), 1e-6)) << name << " " << at;
          EXPECT_TRUE(holds(along_arcs(*arcs, numbers::interval_vec(Vec3(1, 2, 3))),
                            w.dot(Vec3(1, 2, 3)), 1e-11))
              << name << " " << at;
          // What is left of the motion across T and w turns about T.
          const double spin = rate.dot(b) / arc.radius;
          const double lag_in_b = (arcs->lag.magnitude() * 2 + 1e-6) * 10;
          EXPECT_TRUE(holds(hull(arcs->spin[0], arcs->spin[1]), spin, lag_in_b)) << name;
          for (const Vec3& d : {Vec3(1, 0, 0), Vec3(-1, 2, 0.5)}) {
            EXPECT_LE(x.dot(d), furthest(*arcs, numbers::interval_vec(d)) + 1e-11) << name;
          }
        }
      }
    }
  }
}

// Arcs from somewhere between both ends of `first` to the y axis, each at most a right angle.
ContactArcs hand_made(const Interval& first) {
  ContactArcs arcs;
  arcs.toward = {IntervalVec{first, 0, 0}, IntervalVec{0, 1, 0}};
  arcs.inverse_cosine = {1, std::sqrt(2)};
  return arcs;
}

TEST(ContactArcs, reach_furthest_within_what_their_ends_say) {
  const IntervalVec between = numbers::interval_vec(Vec3(1, 1, 0).normalized()),
                    along = numbers::interval_vec(Vec3::UnitX()),
                    beside = numbers::interval_vec(Vec3(-.5, 1, 0).normalized());
  for (const double lowest : {1., .5, -.125}) {
    const ContactArcs arcs = hand_made({lowest, 1});
    EXPECT_NEAR(along_arcs(arcs, between).upper, 1, 1e-12) << lowest;
    EXPECT_NEAR(along_arcs(arcs, along).upper, 1, 1e-12) << lowest;
    EXPECT_NEAR(along_arcs(arcs, Interval(-1) * between).lower, -1, 1e-12) << lowest;
  }
  const IntervalVec any{Interval(0, 2), Interval(0, 2), 0};
  EXPECT_NEAR(along_arcs(hand_made(1), any).upper, 2 * std::sqrt(2), 1e-12);
  // Straight beyond the end at y, nothing reaches further than that end.
  EXPECT_NEAR(along_arcs(hand_made(1), beside).upper, 2 / std::sqrt(5), 1e-12);
  EXPECT_NEAR(along_arcs(hand_made(1), Interval(-1) * between).upper, -std::sqrt(.5), 1e-12);
}

TEST(ContactArcs, reach_as_far_as_the_furthest_place_of_any_corner) {
  for (std::size_t i = 0; i < 4; ++i) {
    ContactArcs arcs;
    arcs.corners.fill(numbers::interval_vec(Vec3(-3, -3, -3)));
    arcs.corners.at(i) = {Interval(-5, 2), Interval(-1), Interval(-1)};
    EXPECT_GE(furthest(arcs, numbers::interval_vec(Vec3::UnitX())), 2);
    EXPECT_LE(furthest(arcs, numbers::interval_vec(Vec3::UnitX())), 2.001);
  }
}

TEST(ContactArcs, are_none_where_balls_envelop_nothing) {
  auto loop = test::loops_of_all_kinds().front().loop;
  std::get<RollingThrough>(loop.motion).radius = -1;
  EXPECT_FALSE(contact_arcs(loop, {0.25, 0.25}));
  std::get<RollingThrough>(loop.motion).sine = 0;
  EXPECT_FALSE(contact_arcs(loop, {0.25, 0.25}));
  EXPECT_FALSE(contact_arcs(loop, {0.5, 1.5}));
}

// Balls that shrink to nothing, or grow as fast as they move, somewhere in a stretch.
TEST(ContactArcs, are_none_where_some_balls_of_the_stretch_envelop_nothing) {
  const auto loops = test::loops_of_all_kinds();
  const CanalFillet honest = std::ranges::find(loops, "rational_0", &test::NamedLoop::name)->loop;
  const auto with = [&](double factor, double least) {
    CanalFillet loop = honest;
    auto& motion = std::get<RationalCrossing>(loop.motion);
    double lowest = 1e9;
    for (PeVector* v : {&motion.origin, &motion.along, &motion.across, &motion.e3, &motion.e4}) {
      v->r *= factor;
    }
    for (int i = 0; i < 64; ++i) {
      lowest = std::min(lowest, ball(loop, i / 10.).radius);
    }
    motion.origin.r += lowest - least;
    return loop;
  };
  for (const CanalFillet& loop : {with(1, -.02), with(60, .5)}) {
    int found = 0;
    for (int i = 0; i < 512; ++i) {
      const double from = i / 256., to = (i + 1) / 256.;
      const bool first = contact_arcs(loop, {from, from}).has_value(),
                 last = contact_arcs(loop, {to, to}).has_value();
      if (first == last) {
        continue;
      }
      ++found;
      double known = first ? from : to, unknown = first ? to : from;
      while (std::abs(known - unknown) > 0x1p-30) {
        const double middle = (known + unknown) / 2;
        (contact_arcs(loop, {middle, middle}) ? known : unknown) = middle;
      }
      // Of the stretch's middle all is known.
      const double step = known > unknown ? 0x1p-24 : -0x1p-24;
      const auto [low, high] = std::minmax({unknown - step, known + 3 * step});
      EXPECT_FALSE(contact_arcs(loop, {low, high})) << i;
      EXPECT_TRUE(contact_arcs(loop, {(low + high) / 2, (low + high) / 2})) << i;
    }
    EXPECT_GE(found, 2);
  }
}

TEST(ContactArcs, have_corners_where_pipes_touch) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    EXPECT_EQ(has_corner(loop, 0) || has_corner(loop, 1), !corners(loop).empty()) << name;
    EXPECT_EQ(has_corner(loop, 0) && has_corner(loop, 1), name.starts_with("equal")) << name;
  }
}

TEST(ContactArcs, see_quadrics_at_their_distance) {
  const JetVec<1> point{constant<1>(3), constant<1>(4), constant<1>(1)};
  const auto cylinder = seen_from<1>(Ring{{0, 0, 0}, {0, 0, 1}, 2, 0}, point);
  EXPECT_TRUE(holds(cylinder.distance[0], 3, 0));
  EXPECT_TRUE(holds(part(cylinder.normal, 0), Vec3(0.6, 0.8, 0), 1e-15));
  const auto cone = seen_from<1>(Ring{{0, 0, 0}, {0, 0, 1}, 2, 0.75}, point);
  EXPECT_TRUE(holds(cone.distance[0], (5 - 2.75) * 0.8, 1e-15));
  EXPECT_TRUE(holds(part(cone.normal, 0), Vec3(0.48, 0.64, -0.6), 1e-15));
}

}  // namespace
}  // namespace dupin::verification
