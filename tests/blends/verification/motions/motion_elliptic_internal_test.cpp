#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "dupin/blends/elliptic_tube.h"
#include "verification/motions/motion.h"

namespace dupin::verification {
namespace {

using std::numbers::pi;

Motion motion_of(const EllipticTube& tube) {
  return motion(tube, motion(Tube({tube.start, tube.end, tube.spine, tube.first})),
                Tube({tube.start, tube.end, tube.spine, tube.second}));
}

// An ellipse at the origin that looks along -x, and one that looks along `out` and is turned by
// `turn` about it against the frame that comes by the plane arc.
EllipticTube tube_between(const Vec3& to, const Vec3& out, double turn, Continuity continuity) {
  const Vec3 up = Vec3::UnitZ(), axis = Eigen::AngleAxisd(turn, out) * up;
  const Ring start{Vec3::Zero(), -Vec3::UnitX(), 2, 0, Ellipse{up, 1.2, 0}};
  const Ring end{to, out, 1.5, 0, Ellipse{axis, .8, 0}};
  const HermiteSpine spine{start.center, to, 8 * Vec3::UnitX(), 8 * out};
  return elliptic_tube(start, end, spine, CubicRadius{2, 1.5}, CubicRadius{1.2, .8}, continuity);
}

double eased(const EllipticTube& tube, double t) {
  return tube.turn * (tube.continuity == Continuity::g1 ? t * t * (3 - 2 * t)
                                                        : t * t * t * (10 - 15 * t + 6 * t * t));
}

// The point in the plane of the section, in a frame that does not spin.
std::complex<double> point(const EllipticTube& tube, double t, double u) {
  return std::complex(evaluate(tube.first, t).value * std::cos(u),
                      evaluate(tube.second, t).value * std::sin(u)) *
         std::polar(1., eased(tube, t));
}

TEST(EllipticMotion, bounds_how_points_move_in_their_planes) {
  const double h = 1e-4;
  for (const Continuity continuity : {Continuity::g1, Continuity::g2}) {
    for (const double turn : {0., .3, -1.2}) {
      const EllipticTube tube = tube_between({6, 5, 0}, Vec3::UnitY(), turn, continuity);
      ASSERT_NEAR(tube.turn, turn, 1e-9);
      const Motion motion = motion_of(tube);
      for (const auto& [from, to] : {std::pair(.05, .1), {.25, .28125}, {.5, .5}, {.6, .9}}) {
        const auto found = motion(from, to);
        ASSERT_TRUE(found);
        for (const double t : {from, (from + to) / 2, to}) {
          const Vec3 center = evaluate(tube.spine, t).position;
          EXPECT_TRUE(test::holds(part(found->center, 0), center, 1e-12));
          for (double u = 0; u < 2 * pi; u += .1) {
            const auto before = point(tube, t - h, u), here = point(tube, t, u),
                       after = point(tube, t + h, u);
            EXPECT_LE(std::abs(here), found->radius[0].magnitude() + 1e-12);
            EXPECT_LE(std::abs(after - before) / (2 * h), found->radius[1].magnitude() + 1e-5);
            EXPECT_LE(std::abs(after - 2. * here + before) / (h * h),
                      found->radius[2].magnitude() + 1e-5);
          }
        }
      }
    }
  }
}

// Where only the turn or only the semi-axes change, some point moves as fast as is said.
TEST(EllipticMotion, is_no_wider_than_what_moves) {
  for (const Continuity continuity : {Continuity::g1, Continuity::g2}) {
    EllipticTube twist = tube_between({9, 0, 0}, Vec3::UnitX(), .7, continuity);
    twist.first = ConstantRadius{2};
    twist.second = ConstantRadius{1};
    const bool is_flat = continuity == Continuity::g2;
    const double t = .25, s = 1 - t;
    const double rate = .7 * (is_flat ? 30 * t * t * s * s : 6 * t * s);
    const double change = .7 * (is_flat ? 60 * t * s * (1 - 2 * t) : 6 * (1 - 2 * t));
    const auto turning = motion_of(twist)(t, t);
    EXPECT_NEAR(turning->radius[0].magnitude(), 2, 1e-12);
    EXPECT_NEAR(turning->radius[1].magnitude(), 2 * rate, 1e-8);
    EXPECT_NEAR(turning->radius[2].magnitude(), 2 * (change + rate * rate), 1e-8);
  }
  EllipticTube narrowing = tube_between({9, 0, 0}, Vec3::UnitX(), 0, Continuity::g1);
  const auto found = motion_of(narrowing)(.25, .25);
  EXPECT_NEAR(found->radius[1].magnitude(), .5 * 6 * .25 * .75, 1e-8);
  EXPECT_NEAR(found->radius[2].magnitude(), .5 * 6 * (1 - .5), 1e-8);
  narrowing.second = CubicRadius{1.2, .2};  // falls faster than the first
  EXPECT_NEAR(motion_of(narrowing)(.25, .25)->radius[1].magnitude(), 6 * .25 * .75, 1e-8);
}

// The rings say how far the axes turn, whatever `turn` says, but for whole half turns.
TEST(EllipticMotion, believes_in_no_turn_that_does_not_arrive) {
  const EllipticTube honest = tube_between({6, 5, 0}, Vec3::UnitY(), 1.2, Continuity::g1);
  const double rate = motion_of(honest)(.5, .5)->radius[1].magnitude();
  const double coarse = .27 * std::pow(pi / 2, 2) / 16;  // of how frames are carried there
  for (const double turn : {0., .6, 1.19}) {
    EllipticTube liar = honest;
    liar.turn = turn;
    EXPECT_GT(motion_of(liar)(.5, .5)->radius[1].magnitude(), rate - 3 * coarse) << turn;
  }
  EllipticTube further = honest;
  further.turn += pi;
  EXPECT_NEAR(motion_of(further)(.5, .5)->radius[1].magnitude() - rate, 1.5 * pi * 1.75, .01);
  EllipticTube round = honest;
  round.end.ellipse.reset();
  round.turn = .1;
  EXPECT_LT(motion_of(round)(.5, .5)->radius[1].magnitude(), rate / 2) << "nowhere to arrive";
}

// An axis in the plane of the arc comes round with it.
TEST(EllipticMotion, follows_axes_to_the_end) {
  const Vec3 out = Vec3::UnitY();
  const Ring start{Vec3::Zero(), -Vec3::UnitX(), 2, 0, Ellipse{Vec3::UnitY(), 1.2, 0}};
  Ring end{Vec3(6, 5, 0), out, 2, 0, Ellipse{-Vec3::UnitX(), 1.2, 0}};
  const HermiteSpine spine{start.center, end.center, 8 * Vec3::UnitX(), 8 * out};
  const auto rate = [&] {
    EllipticTube tube{start, end, spine, ConstantRadius{2}, ConstantRadius{1.2}};
    tube.axis = Vec3::UnitY();
    return motion(tube, motion(Tube({start, end, spine, tube.first})),
                  Tube({start, end, spine, tube.second}))(.5, .5)
        ->radius[1]
        .magnitude();
  };
  EXPECT_LT(rate(), 2 * 1.5 * .08) << "no turn but what the coarse carrying misses";
  end.ellipse->axis = Eigen::AngleAxisd(.3, out) * end.ellipse->axis;
  EXPECT_GT(rate(), 2 * 1.5 * .29);
  EXPECT_LT(rate(), 2 * 1.5 * (.3 * pi / 2 + .08));
}

// On a line, slower and slower to a rest at 17/32 and on.
TEST(EllipticMotion, is_unknown_where_the_spine_rests_on_its_way) {
  const double rest = 17. / 32, rest_on = 1 - rest;
  EllipticTube tube = tube_between({9, 0, 0}, Vec3::UnitX(), .4, Continuity::g1);
  tube.spine =
      HermiteSpine{Vec3::Zero(), Vec3((rest_on * rest_on * rest_on + rest * rest * rest) / 3, 0, 0),
                   Vec3(rest * rest, 0, 0), Vec3(rest_on * rest_on, 0, 0)};
  EXPECT_FALSE(motion_of(tube));
}

TEST(EllipticMotion, is_unknown_where_the_spine_may_stop) {
  EllipticTube tube = tube_between({6, 5, 0}, Vec3::UnitY(), 1.2, Continuity::g1);
  tube.spine = HermiteSpine{Vec3::Zero(), Vec3(6, 5, 0), Vec3::Zero(), Vec3::Zero()};
  EXPECT_FALSE(motion_of(tube));
  tube.end.ellipse.reset();
  ASSERT_TRUE(motion_of(tube));
  EXPECT_FALSE(motion_of(tube)(0, .5));
}

}  // namespace
}  // namespace dupin::verification
