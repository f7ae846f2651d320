#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/ringed/ringed_blends.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"
#include "surfaces/cyclide_discs.h"
#include "surfaces/moving_disc.h"

namespace dupin::surfaces {
namespace {

using numbers::Interval;
using numbers::IntervalVec;

// How far a number is out of an interval.
double out_of(const Interval& x, double value) {
  return std::max({0., x.lower - value, value - x.upper});
}

double out_of(const IntervalVec& x, const Vec3& value) {
  return std::max({out_of(x[0], value.x()), out_of(x[1], value.y()), out_of(x[2], value.z())});
}

// The circle at a parameter, its normal in travel direction.
using CircleAt = std::function<Ring(double)>;
using DiscOver = std::function<std::optional<MovingDisc>(const Interval&)>;

// Values and central differences at points, and over stretches with them.
void expect_disc_of(const CircleAt& circle_at, const DiscOver& disc_over) {
  constexpr double kStep = 1e-5, kDifferences = 1e-6;
  for (const double t : {.1, .5, .9}) {
    const Ring before = circle_at(t - kStep), here = circle_at(t), after = circle_at(t + kStep);
    const Vec3 velocity = (after.center - before.center) / (2 * kStep);
    const Vec3 turning = (after.normal - before.normal) / (2 * kStep);
    const double scale = 1 + velocity.norm() + turning.norm();
    for (const double width : {0., 1e-3, .05}) {
      const auto disc = disc_over({t - width, t + width});
      if (!disc && width == .05) {
        continue;  // the intervals may be too wide to tell
      }
      ASSERT_TRUE(disc.has_value());
      EXPECT_LT(out_of(disc->center, here.center), 1e-12);
      EXPECT_LT(out_of(disc->normal, here.normal), 1e-12);
      EXPECT_LT(out_of(disc->radius, here.radius), 1e-12);
      EXPECT_LT(out_of(disc->velocity, velocity), kDifferences * scale);
      EXPECT_LT(out_of(disc->turning, turning), kDifferences * scale);
      if (width == 0) {
        EXPECT_LT(disc->radius.upper - disc->radius.lower, 1e-11);
        EXPECT_LT(disc->velocity[0].upper - disc->velocity[0].lower, 1e-10 * scale);
      }
    }
  }
}

TEST(MovingDisc, of_a_cyclide_is_the_contact_circles) {
  test::RandomArcs arcs;
  int walls = 0;
  for (int i = 0; i < 30; ++i) {
    SCOPED_TRACE(i);
    const PeArc arc = arcs.next();
    const CyclidePiece piece = cyclide_piece(arc);
    expect_disc_of([&](double t) { return circle_at(arc, t); },
                   [&](const Interval& t) { return CyclideDiscs(piece).over(t); });
    // The inner skin is the offset piece.
    const double wall = 0.1;
    try {
      const PeArc inner = offset(arc, -wall);
      expect_disc_of([&](double t) { return circle_at(inner, t); },
                     [&](const Interval& t) { return CyclideDiscs(piece).over(t, wall); });
      ++walls;
    } catch (const Error&) {
      // too thick
    }
  }
  EXPECT_GT(walls, 20);
}

TEST(MovingDisc, of_a_ringed_surface_is_its_rings) {
  for (const RationalRingedSurface& surface : {test::cone_to_cylinder(), test::general_ends()}) {
    expect_disc_of(
        [&](double t) {
          const MovingRing ring = ring_at(surface, t);
          return Ring{ring.center, ring.normal, ring.radius};
        },
        [&](const Interval& t) { return moving_disc(surface, t, false); });
  }
}

// Out of a plate, where the circle stands still and its radius alone moves.
TEST(MovingDisc, that_comes_to_rest_is_steered) {
  const RationalRingedSurface surface =
      ringed_blend(along_plate({Vec3(0, 0, 0), Vec3::UnitZ(), 2}, -3),
                   along_canal({Vec3(.5, 0, 4), Vec3::UnitZ(), 1}, 0, 4));
  const Interval first{0, 0x1p-8};
  const auto plain = moving_disc(surface, first, false),
             steered = moving_disc(surface, first, true);
  ASSERT_TRUE(plain && steered);
  EXPECT_LE(pace(*plain, 0).advance, 0);
  EXPECT_GT(pace(*steered, 0).advance, 0);
  // The same direction where it does move.
  const auto there = moving_disc(surface, 0x1p-8, false), then = moving_disc(surface, first, true);
  const Vec3 way(there->velocity[0].lower, there->velocity[1].lower, there->velocity[2].lower);
  EXPECT_LT(out_of(then->velocity, way / 0x1p-8), 1e-6);
  // Elsewhere nothing is divided.
  const Interval inside{.25, .5};
  EXPECT_EQ(moving_disc(surface, inside, true)->velocity[2].lower,
            moving_disc(surface, inside, false)->velocity[2].lower);
}

TEST(DiscPace, is_how_far_a_disc_moves_along_and_across_and_turns) {
  const Vec3 normal(.6, 0, .8), velocity = 3 * normal + 2 * Vec3::UnitY(), turning(0, -.5, 0);
  const MovingDisc disc{numbers::interval_vec(Vec3(1, 2, 3)),
                        numbers::interval_vec(normal),
                        numbers::interval_vec(velocity),
                        numbers::interval_vec(turning),
                        {1, 1.5}};
  const DiscPace found = pace(disc, .25);
  EXPECT_NEAR(found.advance, 3, 1e-14);
  EXPECT_LE(found.advance, 3);
  EXPECT_NEAR(found.sideways, 2, 1e-14);
  EXPECT_GE(found.sideways, 2);
  EXPECT_NEAR(found.turning, .5, 1e-14);
  EXPECT_GE(found.turning, .5);
  EXPECT_EQ(found.radius.upper, 1.5);
  EXPECT_EQ(found.width, .25);
}

// The way of a disc of radius 1 about a circle of this radius, by this angle, in equal stretches.
std::vector<DiscPace> bend(double radius, double angle, int stretches) {
  return std::vector<DiscPace>(std::size_t(stretches),
                               DiscPace{radius * angle, 0, angle, 1, 1. / stretches});
}

// Discs in planes through a torus' axis meet there and nowhere else.
TEST(DiscPace, tells_discs_that_advance_from_those_that_come_back) {
  for (const int stretches : {1, 5}) {
    EXPECT_TRUE(advances(bend(1.2, .5, stretches)));
    EXPECT_TRUE(advances(bend(4, .99, stretches)));
    EXPECT_FALSE(advances(bend(.99, .01, stretches)));
    EXPECT_FALSE(advances(bend(1, .5, stretches)));
    EXPECT_FALSE(advances(bend(4, 1.01, stretches))) << "turns too far";
  }
  const DiscPace straight{1, 0, 0, {1, 2}, 1};
  EXPECT_TRUE(advances({straight, straight}));
  const auto with = [&](const auto& change) {
    DiscPace changed = straight;
    change(changed);
    return std::vector{straight, changed};
  };
  EXPECT_FALSE(advances(with([](DiscPace& pace) { pace.advance = 0; })));
  EXPECT_FALSE(advances(with([](DiscPace& pace) { pace.radius = {0, 1}; })));
  // Sideways is no harm unless the discs tilt.
  EXPECT_TRUE(advances(with([](DiscPace& pace) { pace.sideways = 9; })));
  EXPECT_FALSE(advances(with([](DiscPace& pace) {
    pace.sideways = 9;
    pace.turning = .2;
  })));
  // The largest radius on the way counts everywhere.
  std::vector<DiscPace> growing = bend(2, .5, 2);
  EXPECT_TRUE(advances(growing));
  growing.push_back({50, 0, 0, {1, 3}, 1});
  EXPECT_FALSE(advances(growing));
}

}  // namespace
}  // namespace dupin::surfaces
