#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/rational_ringed_surface.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"
#include "verification/solid.h"
#include "verification/work.h"

namespace dupin::verification {
namespace {

using test::holds;

EllipticTube elliptic_pipe() {
  EllipticTube tube;
  tube.start = {Vec3(0, 0, 0), -Vec3::UnitX(), 2, 0, Ellipse{Vec3::UnitY(), 1, 0}};
  tube.end = {Vec3(5, 0, 0), Vec3::UnitX(), 2, 0, Ellipse{Vec3::UnitY(), 1, 0}};
  tube.spine = LineSpine{Vec3(0, 0, 0), Vec3(5, 0, 0)};
  tube.first = ConstantRadius{2};
  tube.second = ConstantRadius{1};
  tube.axis = Vec3::UnitY();
  return tube;
}

TEST(Solid, of_a_chain_has_its_pieces_between_whole_numbers) {
  const Solid solid =
      test::solid(test::cylinder({0, 0, 0}, {1, 0, 0}, 1), test::cylinder({1, 0, 0}, {4, 0, 0}, 1));
  EXPECT_EQ(solid.length(), 2);
  EXPECT_EQ(solid.ball(), nullptr);
  EXPECT_TRUE(solid.is_full());
  EXPECT_FALSE(solid.closed());
  const Piece* all = solid.pieces().data();
  EXPECT_EQ(solid.piece({0, 1}), all);
  EXPECT_EQ(solid.piece({.5, .5}), all);
  EXPECT_EQ(solid.piece({1, 2}), all + 1);
  for (const ParameterInterval& t :
       {ParameterInterval{.5, 1.5}, {-.5, .5}, {1.5, 2.5}, {.75, .5}, {2, 2}, {5, 6}}) {
    EXPECT_EQ(solid.piece(t), nullptr) << t.from << " " << t.to;
    EXPECT_FALSE(solid.discs(t)) << t.from << " " << t.to;
  }
  const auto discs = solid.discs({1.5, 1.5});
  ASSERT_TRUE(discs);
  EXPECT_TRUE(holds(discs->centers.front(), Vec3(2.5, 0, 0), 1e-15));
}

TEST(Solid, of_a_ball_has_its_centre_everywhere) {
  const Solid solid = test::ball(Vec3(1, 2, 3), 4);
  ASSERT_NE(solid.ball(), nullptr);
  EXPECT_EQ(solid.length(), 1);
  EXPECT_TRUE(solid.pieces().empty());
  EXPECT_EQ(solid.piece({0, 1}), nullptr);
  const auto discs = solid.discs({.25, .5});
  ASSERT_TRUE(discs);
  EXPECT_TRUE(discs->tangents.empty());
  EXPECT_NEAR(furthest(*discs, numbers::interval_vec(Vec3::UnitY())), 6, 1e-14);
}

TEST(Solid, of_another_shape_is_nothing) {
  CertifiedPart part;
  part.shape = Chain{};
  const Solid solid(part);
  EXPECT_EQ(solid.length(), 0);
  EXPECT_FALSE(solid.is_full());
  EXPECT_EQ(solid.ball(), nullptr);
}

TEST(Solid, of_an_elliptic_tube_has_the_larger_discs_and_is_not_full) {
  const Solid solid = test::solid(elliptic_pipe());
  EXPECT_FALSE(solid.is_full());
  ASSERT_EQ(solid.pieces().size(), 1u);
  const Piece& piece = solid.pieces().front();
  EXPECT_EQ(piece.tubes.size(), 2u);
  ASSERT_TRUE(piece.motion);
  EXPECT_EQ(piece.motion(.25, .5)->radius[0].magnitude(), 2);
  const auto disc = piece.steered(.25, .5);
  ASSERT_TRUE(disc);
  EXPECT_TRUE(holds(disc->radius[0], 2));
  EXPECT_NEAR(furthest(*solid.discs({0, 1}), numbers::interval_vec(Vec3::UnitZ())), 2, 1e-14);
}

// Spheres of radius 4 to 7 along x, which grow half as fast as they move: the circles lie where x
// is -2 and 2.5, those of the inner skin where it is -1.5 and 3.
CertifiedPart hollow_horn() {
  CertifiedPart horn = test::part(test::cyclide_piece(PeArc::from(
      test::sphere(0, 0, 0, 4), test::direction(Vec3::UnitX(), .5), test::sphere(6, 0, 0, 7))));
  std::get<Chain>(horn.shape).wall = 1;
  return horn;
}

TEST(Solid, that_is_hollow_has_the_rim_that_leans_over_its_end) {
  const auto along_x = [](const Solid& solid, const ParameterInterval& t) {
    return furthest(solid.discs(t).value(), numbers::interval_vec(Vec3::UnitX()));
  };
  CertifiedPart part = hollow_horn();
  const Solid horn(part);
  EXPECT_NEAR(horn.rim(End::end).value().beyond, .5, 1e-12);
  EXPECT_NEAR(horn.rim(End::start).value().beyond, -.5, 1e-12) << "within the outer skin";
  EXPECT_NEAR(along_x(horn, {.9375, 1}), 3, 1e-6);
  EXPECT_LT(along_x(horn, {.875, .9375}), 2.5);
  EXPECT_GE(horn.boxes().front()[0].upper, 3);
  std::get<Chain>(part.shape).wall = 0;
  const Solid full(part);
  EXPECT_FALSE(full.rim(End::end));
  EXPECT_NEAR(along_x(full, {.9375, 1}), 2.5, 1e-6);
}

TEST(Solid, that_is_hollow_goes_on_in_another_if_their_rims_are_one) {
  const auto horn = [](double from, double slope, double wall) {
    CertifiedPart part = test::part(test::cyclide_piece(PeArc::from(
        test::sphere(from, 0, 0, 4 + slope * from), test::direction(Vec3::UnitX(), slope),
        test::sphere(from + 6, 0, 0, 4 + slope * (from + 6)))));
    std::get<Chain>(part.shape).wall = wall;
    return Solid(part);
  };
  const auto before = horn(0, .5, 1).rim(End::end), none = std::optional<Rim>();
  EXPECT_TRUE(have_rims_apart(before, horn(6, .5, 1).rim(End::start), 1e-9));
  EXPECT_TRUE(have_rims_apart(horn(6, .5, 1).rim(End::start), before, 1e-9));
  EXPECT_FALSE(have_rims_apart(before, horn(6, .5, 1.25).rim(End::start), .1));
  EXPECT_FALSE(have_rims_apart(before, horn(6, .25, 1).rim(End::start), .1));
  EXPECT_FALSE(have_rims_apart(before, none, .49));
  EXPECT_FALSE(have_rims_apart(none, before, .49));
  EXPECT_TRUE(have_rims_apart(before, none, .51));
  EXPECT_TRUE(have_rims_apart(horn(6, .5, 1).rim(End::start), none, 0)) << "it is within";
}

// Of what is known within bounds only, the worst that is within them.
TEST(Solid, knows_of_rims_and_normals_within_bounds) {
  const Interval zero(0), wide(0, .5);
  const Rim at{{zero, zero, zero}, 1, .3}, near{{wide, zero, zero}, 1, .3};
  EXPECT_FALSE(have_rims_apart(at, near, .25)) << "they may be as far as .5 from each other";
  EXPECT_TRUE(have_rims_apart(at, near, .3)) << "they are not needed then";
  const Rim far{{wide, zero, zero}, 1, .7};
  EXPECT_TRUE(have_rims_apart(at, far, .51));
  EXPECT_FALSE(have_rims_apart(at, far, .49));
  const numbers::IntervalVec along{1, zero, zero}, turned{Interval(.8, 1), Interval(0, .6), zero};
  EXPECT_GE(step_between({along, along}, {turned, along}).turn.upper, std::atan2(.6, .8));
  EXPECT_LT(step_between({along, along}, {along, along}).turn.upper, 1e-9);
  EXPECT_EQ(step_between({along, along}, {along, along}).gap.upper, 0);
  EXPECT_GE(step_between({along, along}, {along, turned}).gap.upper, std::hypot(.2, .6));
  EXPECT_LT(step_between({along, along}, {along, turned}).gap.upper, .64);
}

TEST(Solid, knows_how_much_it_turns_at_joints) {
  const auto line = [](const Vec3& from, const Vec3& to) {
    return test::cylinder_of_bezier(from, to, 1);
  };
  CertifiedPart part = test::part(line({0, 0, 0}, {5, 0, 0}), line({5, 0, 0}, {9, 0, 0}),
                                  line({9, 0, 0}, {9, 7, 0}));
  const Solid solid(part);
  EXPECT_NEAR(solid.step_at(1).turn.upper, 0, 1e-14);
  EXPECT_GE(solid.step_at(2).turn.upper, std::numbers::pi / 2);
  EXPECT_LT(solid.step_at(2).turn.upper, 2.5);
  EXPECT_NEAR(solid.step_at(2).gap.upper, 0, 1e-12);
  EXPECT_NEAR(solid.step_at(0).gap.upper, std::hypot(9, 7), 1e-12) << "if it were closed";
  EXPECT_TRUE(holds(solid.outward(End::start).center, Vec3(0, 0, 0), 1e-14));
  EXPECT_TRUE(holds(solid.outward(End::end).center, Vec3(9, 7, 0), 1e-14));
  EXPECT_TRUE(holds(solid.outward(End::start).normal, Vec3(-1, 0, 0), 1e-14));
  EXPECT_TRUE(holds(solid.outward(End::end).normal, Vec3(0, 1, 0), 1e-14));
  EXPECT_NEAR(solid.size_of_piece(0), std::sqrt(7. * 7 + 2. * 2 + 2. * 2), 1e-12);
}

TEST(Solid, with_kneecaps_has_the_balls_of_its_joints) {
  CertifiedPart part;
  part.shape = kneecap_chain(test::lune_spheres());
  const Solid arm(part);
  EXPECT_TRUE(arm.has_kneecaps());
  EXPECT_FALSE(arm.is_full());
  EXPECT_EQ(arm.length(), 2);
  ASSERT_EQ(arm.knees().size(), 1U);
  EXPECT_EQ(arm.knees()[0].center, Vec3(4, 1, 0));
  EXPECT_EQ(arm.knees()[0].radius, 1);
  for (const ParameterInterval& t : {ParameterInterval{0, 1}, {.5, 1}, {1, 1}, {1, 2}, {0, 2}}) {
    EXPECT_EQ(knees_at(arm, t).size(), 1U) << t.from << " " << t.to;
  }
  for (const ParameterInterval& t : {ParameterInterval{0, .75}, {0, 0}, {1.25, 2}, {2, 2}}) {
    EXPECT_TRUE(knees_at(arm, t).empty()) << t.from << " " << t.to;
  }
  const Solid pipes =
      test::solid(test::cylinder({0, 0, 0}, {1, 0, 0}, 1), test::cylinder({1, 0, 0}, {4, 0, 0}, 1));
  EXPECT_FALSE(pipes.has_kneecaps());
  EXPECT_TRUE(knees_at(pipes, {0, 2}).empty());
}

TEST(Solid, with_kneecaps_has_pieces_that_touch_one_ball) {
  CertifiedPart part;
  const Chain arm = kneecap_chain(test::lune_spheres());
  const auto refused = [&](const auto& change) {
    Chain changed = arm;
    change(changed);
    part.shape = changed;
    EXPECT_THROW(Solid{part}, Error);
  };
  part.shape = arm;
  EXPECT_NO_THROW(Solid{part});
  refused([](Chain& c) { std::get<CyclidePiece>(c.pieces[0]).last.r += 1e-15; });
  refused([](Chain& c) { std::get<CyclidePiece>(c.pieces[1]).first.m.z() = 1e-300; });
  refused([](Chain& c) { c.closed = true; });
  refused([](Chain& c) { c.wall = 1; });
  refused([](Chain& c) { c.pieces[1] = test::cylinder({0, 0, 0}, {1, 0, 0}, 1); });
  refused([](Chain& c) { c.pieces = {test::cylinder({0, 0, 0}, {1, 0, 0}, 1)}; });
  Chain hollow = arm;
  hollow.wall = .5;
  part.shape = hollow;
  EXPECT_EQ(Solid(part).wall(), .5);
}

TEST(Solid, that_is_hollow_has_an_inner_skin) {
  const PeArc arc = PeArc::from(test::sphere(0, 0, 0, 1), test::direction(Vec3::UnitX(), 0),
                                test::sphere(3, 2, 0, .8));
  CertifiedPart hollow = test::part(test::cyclide_piece(arc));
  EXPECT_FALSE(Solid(hollow).pieces().front().inner);
  EXPECT_TRUE(Solid(hollow).is_full());
  std::get<Chain>(hollow.shape).wall = .25;
  const Solid solid(hollow);
  EXPECT_FALSE(solid.is_full());
  const Motion& inner = solid.pieces().front().inner;
  ASSERT_TRUE(inner);
  EXPECT_TRUE(holds(inner(0, 0)->radius[0], .75, 1e-15));
}

// Nothing is claimed of the inner skin of anything else, so there must be none.
TEST(Solid, refuses_walls_of_what_is_not_hollow) {
  CertifiedPart pipe = test::part(test::cylinder({0, 0, 0}, {1, 0, 0}, 1));
  std::get<Chain>(pipe.shape).wall = .25;
  EXPECT_THROW(Solid{pipe}, Error);
  const PeArc arc = PeArc::from(test::sphere(0, 0, 0, 1), test::direction(Vec3::UnitX(), 0),
                                test::sphere(3, 2, 0, .8));
  CertifiedPart piece = test::part(test::cyclide_piece(arc));
  std::get<Chain>(piece.shape).wall = -.25;
  EXPECT_THROW(Solid{piece}, Error);
}

TEST(Solid, discs_of_cyclides_hold_those_of_the_stretch) {
  test::RandomArcs arcs;
  for (int i = 0; i < 10; ++i) {
    const PeArc arc = arcs.next();
    const Solid solid = test::solid(test::cyclide_piece(arc));
    const auto discs = solid.discs({.5, .50390625});
    ASSERT_TRUE(discs);
    for (const Vec3& w : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(.6, 0, .8)}) {
      double reached = -1e9;
      for (const double t : {.5, .502, .50390625}) {
        const Ring ring = circle_at(arc, t);
        reached = std::max(reached, w.dot(ring.center) + ring.radius * w.cross(ring.normal).norm());
      }
      const double bound = furthest(*discs, numbers::interval_vec(w));
      EXPECT_GE(bound, reached - 1e-10);
      EXPECT_LE(bound, reached + 1);
    }
  }
}

TEST(Solid, discs_of_rational_tubes_hold_those_of_the_stretch) {
  const RationalRingedTube tube = oblique_tube(Vec3(0, 0, 0), Vec3(3, 0, 1), Vec3(1, 0, 0), 1, .5);
  const Solid solid = test::solid(tube);
  EXPECT_TRUE(solid.is_full());
  const auto discs = solid.discs({.25, .5});
  ASSERT_TRUE(discs);
  const double reached = furthest(*discs, numbers::interval_vec(Vec3::UnitZ()));
  EXPECT_GE(reached, .5 + .75);  // at t = 1/2: the centre is 1/2 high, the radius 3/4
  EXPECT_GE(reached, .25 + .875);
  EXPECT_LE(reached, .5 + .875 + 1e-9);
}

// They would be spent by a claim that is not made, and be missing for those that are.
TEST(Solid, boxes_of_pieces_are_no_work_that_is_limited) {
  const RationalRingedTube tube = oblique_tube(Vec3(0, 0, 0), Vec3(3, 0, 1), Vec3(1, 0, 0), 1, .5);
  const Solid solid = test::solid(tube);
  const WorkLimit limit(1000);
  ASSERT_EQ(solid.boxes().size(), 1u);
  EXPECT_EQ(limit.left(), 1000u);
  EXPECT_TRUE(std::isfinite(solid.boxes()[0][0].upper));
  (void)solid.discs({0, .5});
  EXPECT_LT(limit.left(), 1000u) << "as what is asked for by claims is";
}

TEST(Solid, stretches_are_cut_at_whole_numbers) {
  const auto pieces = cut({.5, 2.25});
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[0], (ParameterInterval{.5, 1}));
  EXPECT_EQ(pieces[1], (ParameterInterval{1, 2}));
  EXPECT_EQ(pieces[2], (ParameterInterval{2, 2.25}));
  EXPECT_EQ(cut({1, 2}).size(), 1u);
  EXPECT_TRUE(cut({1, 1}).empty());
  EXPECT_EQ(within_piece({2.25, 3}), (ParameterInterval{.25, 1}));
}

}  // namespace
}  // namespace dupin::verification
