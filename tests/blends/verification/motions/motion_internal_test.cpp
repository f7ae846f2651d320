#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "dupin/blends/ringed_blend.h"
#include "support/cyclide_cases.h"
#include "support/paper_surfaces.h"
#include "verification/motions/motion.h"

namespace dupin::verification {
namespace {

using test::holds;

// A disc in doubles, as the evaluators of the surfaces say it is.
struct Disc {
  Vec3 center, normal;
  double radius = 0;
};

using Discs = std::function<Disc(double t)>;

Discs discs_of(const RingedSurface& surface) {
  return [=](double t) -> Disc {
    const SpinePoint y = evaluate(surface.spine, t);
    return {y.position, y.first.normalized(), evaluate(surface.radius, t).value};
  };
}

Discs discs_of(const PeArc& arc) {
  return [=](double t) -> Disc {
    const Ring ring = circle_at(arc, t);
    return {ring.center, ring.normal, ring.radius};
  };
}

Discs discs_of(const RationalRingedSurface& surface) {
  return [=](double t) -> Disc {
    const MovingRing ring = ring_at(surface, t);
    return {ring.center, ring.normal, ring.radius};
  };
}

// First and second differences, good to some 1e-5.
template <class Value>
std::array<Value, 3> jet(const std::function<Value(double)>& f, double t) {
  const double h = 1e-4;
  const Value a = f(t - h), b = f(t), c = f(t + h);
  return {b, Value((c - a) / (2 * h)), Value((a - 2 * b + c) / (h * h))};
}

// The motion over a stretch holds the discs of the stretch with their derivatives, and is narrow
// at one place.
void expect_encloses(const Motion& motion, const Discs& discs, int orders = 3) {
  for (const auto& [from, to] : {std::pair(.25, .28125), {.5, .5}, {.75, .875}}) {
    const auto found = motion(from, to);
    ASSERT_TRUE(found);
    for (const double t : {from, (from + to) / 2, to}) {
      const auto c = jet<Vec3>([&](double at) { return discs(at).center; }, t);
      const auto n = jet<Vec3>([&](double at) { return discs(at).normal; }, t);
      const auto r = jet<double>([&](double at) { return discs(at).radius; }, t);
      for (std::size_t k = 0; k < std::size_t(orders); ++k) {
        const double slack = k == 0 ? 1e-12 : 1e-4 * (1 + c[k].norm());
        EXPECT_TRUE(holds(part(found->center, k), c[k], slack)) << t << " " << k;
        EXPECT_TRUE(holds(part(found->normal, k), n[k], slack)) << t << " " << k;
        EXPECT_TRUE(holds(found->radius[k], r[k], slack)) << t << " " << k;
      }
    }
    if (from == to) {
      for (std::size_t k = 0; k < std::size_t(orders); ++k) {
        EXPECT_LT(found->radius[k].upper - found->radius[k].lower, 1e-9);
        for (const auto& v : {part(found->center, k), part(found->normal, k)}) {
          EXPECT_LT(numbers::norm(v - v).upper, 1e-8);
        }
      }
    }
  }
}

TEST(Motion, of_ringed_surfaces_holds_their_discs) {
  const BezierSpine rational{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 1, 0), Vec3(3, 2, 1)},
                             {1, 2, .5, 1}};
  for (const RingedSurface& surface :
       {test::cylinder({0, 0, 0}, {1, 2, 3}, .5), test::cone({0, 0, 0}, {3, 0, 0}, .5, 1),
        test::figure6(), test::figure6(CyclideRadius{1, 2}),
        RingedSurface{{}, {}, rational, BezierRadius{{.5, .7, .3}}}}) {
    expect_encloses(motion(Tube(surface)), discs_of(surface));
  }
}

// All discs of an arc are one, turned: what does not change along it is that of the middle.
TEST(Motion, of_an_arc_is_that_of_the_disc_in_its_middle) {
  const RingedSurface surface = test::elbow(3, 2, 1);
  const Discs discs = discs_of(surface);
  for (const auto& [from, to] : {std::pair(0., 1.), {.25, .5}}) {
    const auto found = motion(Tube(surface))(from, to);
    ASSERT_TRUE(found);
    const Disc disc = discs((from + to) / 2);
    EXPECT_TRUE(holds(part(found->center, 0), disc.center, 1e-14));
    EXPECT_TRUE(holds(part(found->normal, 0), disc.normal, 1e-14));
    EXPECT_TRUE(holds(numbers::norm(part(found->normal, 1)), 2, 1e-14));
    EXPECT_TRUE(holds(numbers::norm(part(found->center, 1)), 6, 1e-14));
    EXPECT_TRUE(holds(numbers::norm(part(found->center, 2)), 12, 1e-14));
  }
}

TEST(Motion, of_an_inner_skin_is_that_of_the_parallel_piece) {
  const PeArc arc = PeArc::from(test::sphere(0, 0, 0, 1), test::direction(Vec3::UnitX(), .1),
                                test::sphere(3, 2, .5, .8));
  const CyclidePiece piece = test::cyclide_piece(arc);
  expect_encloses(motion(piece, 0), discs_of(arc));
  expect_encloses(motion(piece, .25), discs_of(offset(arc, -.25)));
}

TEST(Motion, of_rational_ringed_surfaces_holds_their_rings) {
  const RationalRingedSurface surface =
      ringed_blend(along_oblique_cone({Vec3(0, 0, 0), Vec3::UnitZ(), 1}, Vec3(.6, 0, -3), 1.2),
                   along_canal({Vec3(4, 1, 4), Vec3::UnitX(), .8}, 0, 3));
  expect_encloses(motion(surface), discs_of(surface));
  expect_encloses(steered_motion(surface), discs_of(surface), 2);
  // The spin turns the normal: n' = omega x n.
  const auto disc = motion(surface)(.5, .5);
  ASSERT_TRUE(disc && disc->spin);
  const IntervalVec turned = numbers::cross((*disc->spin)[0], part(disc->normal, 0));
  const MovingRing ring = ring_at(surface, .5);
  EXPECT_TRUE(holds(turned, ring.normal_rate, 1e-13));
}

TEST(Motion, that_is_steered_does_not_rest_at_a_plate) {
  const RationalRingedSurface surface =
      ringed_blend(along_plate({Vec3(0, 0, 0), Vec3::UnitZ(), 2}, -3),
                   along_canal({Vec3(.5, 0, 4), Vec3::UnitZ(), 1}, 0, 4));
  const auto plain = motion(surface)(0, .125), steered = steered_motion(surface)(0, .125);
  ASSERT_TRUE(plain && steered);
  const auto advance = [](const MovingDisc& disc) {
    return numbers::dot(part(disc.center, 1), part(disc.normal, 0));
  };
  EXPECT_LE(advance(*plain).lower, 0);
  EXPECT_GT(advance(*steered).lower, 0);
  // Away from the end nothing is divided out.
  const auto there = steered_motion(surface)(.5, .5);
  ASSERT_TRUE(there);
  EXPECT_TRUE(holds(part(there->center, 1), ring_at(surface, .5).center_rate, 1e-12));
}

// By the distance from the end in the parameter, everywhere on a stretch that reaches the end.
TEST(Motion, that_is_steered_has_the_rates_divided_by_one_function) {
  const RationalRingedSurface surface =
      ringed_blend(along_plate({Vec3(0, 0, 0), Vec3::UnitZ(), 2}, -3),
                   along_canal({Vec3(.5, 0, 4), Vec3(.1, .2, 1).normalized(), 1}, 0, 4));
  RationalRingedSurface backwards = surface;
  std::reverse(backwards.center.begin(), backwards.center.end());
  std::reverse(backwards.radius.begin(), backwards.radius.end());
  std::reverse(backwards.rotation.begin(), backwards.rotation.end());
  const auto at_start = steered_motion(surface)(0, .03125),
             at_end = steered_motion(backwards)(.96875, 1);
  ASSERT_TRUE(at_start && at_end);
  for (const double t : {.03125, .015625, .0078125}) {
    const MovingRing first = ring_at(surface, t), last = ring_at(backwards, 1 - t);
    EXPECT_TRUE(holds(part(at_start->center, 1), first.center_rate / t, 1e-11)) << t;
    EXPECT_TRUE(holds(part(at_start->normal, 1), first.normal_rate / t, 1e-11)) << t;
    EXPECT_TRUE(holds(part(at_end->center, 1), last.center_rate / t, 1e-11)) << t;
    EXPECT_TRUE(holds(part(at_end->normal, 1), last.normal_rate / t, 1e-11)) << t;
  }
}

// Normals rest, and so do two coordinates of the centre.
TEST(Motion, that_is_steered_is_the_plain_one_where_something_moves) {
  RationalRingedSurface straight;
  straight.center = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)};
  straight.radius = {1, 1, 1, 1};
  straight.rotation = {{1, 0, 0, 0}, {1, 0, 0, 0}};
  for (const auto& [from, to] : {std::pair(0., 0.), {1., 1.}}) {
    const auto found = steered_motion(straight)(from, to);
    ASSERT_TRUE(found);
    EXPECT_TRUE(holds(part(found->center, 1), Vec3(3, 0, 0), 1e-14));
    EXPECT_LT(numbers::norm(part(found->center, 1)).upper, 3.1);
  }
}

TEST(Motion, is_none_where_the_spine_may_stand_still) {
  // The cubic turns back in its middle.
  RingedSurface surface = test::cylinder({0, 0, 0}, {1, 0, 0}, 1);
  surface.spine = BezierSpine{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 0)}};
  const Motion there_and_back = motion(Tube(surface));
  EXPECT_FALSE(there_and_back(.25, .75));
  EXPECT_TRUE(there_and_back(0, .25));
}

// Along a straight way the normal does not turn, however unevenly it is gone and wherever it leads.
TEST(Motion, of_what_is_straight_does_not_turn) {
  const Vec3 along = Vec3(1, 2, -.3).normalized();
  RingedSurface surface;
  surface.radius = CubicRadius{1, 2};
  std::vector<Vec3> points;
  for (const double at : {0., 1., 1.5, 4., 4.01, 4.02}) {
    points.emplace_back(at * along);
  }
  surface.spine = BezierSpine{points, {}};
  const auto disc = motion(Tube(surface))(.25, .75);
  ASSERT_TRUE(disc);
  EXPECT_LT(numbers::norm(part(disc->normal, 1)).upper, 1e-12);
  EXPECT_LT(numbers::norm(part(disc->normal, 2)).upper, 1e-10);
}

// An arm that flares towards its hub: its circles advance, which few looks show, and likewise of
// the inner skin.
TEST(Motion, of_a_straight_piece_of_a_cyclide_advances_all_along) {
  const Vec3 along = Vec3(1, 2, -.3).normalized();
  const PeArc arc =
      PeArc::from(test::sphere(0, 0, 0, 2), test::direction(along, 0), {5.4 * along, 5.53});
  const CyclidePiece piece = test::cyclide_piece(arc);
  for (const double wall : {0., .5}) {
    for (int i = 0; i < 4; ++i) {
      const auto disc = motion(piece, wall)(i / 4., (i + 1) / 4.);
      ASSERT_TRUE(disc);
      EXPECT_GT(numbers::dot(part(disc->center, 1), part(disc->normal, 0)).lower, 0)
          << wall << " " << i;
    }
  }
  expect_encloses(motion(piece, 0), discs_of(arc));
  expect_encloses(motion(piece, .5), discs_of(offset(arc, -.5)));
}

}  // namespace
}  // namespace dupin::verification
