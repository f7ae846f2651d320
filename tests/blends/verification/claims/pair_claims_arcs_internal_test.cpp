#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "verification/claims/pair_claims.h"

// Lemma 5 of docs/certificate_format.md: discs along lines and arcs.
namespace dupin::verification {
namespace {

using std::numbers::pi;

const JoinedEnds kEndToStart{End::end, End::start};

bool is_embedded(const Solid& solid, const std::vector<DiscPairs>& leaves) {
  return follows(solid, EmbeddedClaim{Verdict::proved, leaves, {}},
                 {Verdict::proved, 0x1p-60, {}, {}});
}

bool are_apart(const Solid& first, const Solid& second, const std::vector<JoinedEnds>& joints,
               const ParameterInterval& t, const ParameterInterval& s) {
  const std::vector<DiscPairs> leaves{{t, s, {}}};
  const ClearanceClaim claim{0, 1, Verdict::proved, 0, leaves, {}};
  return follows(first, second, joints, claim);
}

const std::vector<DiscPairs> kWhole{{{0, 1}, {0, 1}, {}}};

RingedSurface pipe_to(double bend, double radius) {
  return test::cylinder({bend, -30, 0}, {bend, 0, 0}, radius);
}

// An elbow whose numbers make an ellipse, of which one semi-axis is longer than the other one by
// this share, as an axis may be by what is rounded.
RingedSurface uneven_elbow(double bend, double angle, double radius, double share) {
  RingedSurface result = test::elbow(bend, angle, radius);
  std::get<ArcSpine>(result.spine).axis *= 1 + share;
  return result;
}

TEST(ArcLemma, a_bend_is_embedded_just_where_its_radius_is_larger) {
  for (const double angle : {2., 3., 6., 6.283}) {
    EXPECT_TRUE(is_embedded(test::solid(test::elbow(4, angle, 4 * (1 - 0x1p-48))), kWhole));
    EXPECT_FALSE(is_embedded(test::solid(test::elbow(4, angle, 4)), kWhole));
    EXPECT_FALSE(is_embedded(test::solid(test::elbow(4, angle, 4.001)), kWhole));
  }
}

TEST(ArcLemma, a_bend_is_embedded_just_where_it_is_no_full_turn) {
  const double turn = 2 * pi;  // a little less than that
  EXPECT_TRUE(is_embedded(test::solid(test::elbow(4, turn, 1)), kWhole));
  EXPECT_FALSE(is_embedded(test::solid(test::elbow(4, std::nextafter(turn, 7), 1)), kWhole));
  EXPECT_FALSE(is_embedded(test::solid(test::elbow(4, 7, 1)), kWhole));
}

TEST(ArcLemma, it_is_the_largest_radius_that_counts) {
  RingedSurface bend = test::elbow(4, 5, 1);
  for (const auto& [law, holds] : {std::pair<RadiusLaw, bool>{LinearRadius{1, 3.9}, true},
                                   {LinearRadius{1, 4}, false},
                                   {LinearRadius{4, 1}, false},
                                   {CyclideRadius{1, 3.9}, true},
                                   {CyclideRadius{4.1, 3.9}, false},
                                   {BezierRadius{{1, 4.5, 1}}, false},
                                   {BezierRadius{{-4.5}}, false}}) {
    bend.radius = law;
    EXPECT_EQ(is_embedded(test::solid(bend), kWhole), holds);
  }
  EllipticTube oval;
  oval.start = bend.start;
  oval.end = bend.end;
  oval.spine = bend.spine;
  oval.axis = Vec3::UnitZ();
  oval.first = ConstantRadius{1};
  oval.second = ConstantRadius{3.9};
  EXPECT_TRUE(is_embedded(test::solid(oval), kWhole));
  oval.second = ConstantRadius{4.1};
  EXPECT_FALSE(is_embedded(test::solid(oval), kWhole));
  std::swap(oval.first, oval.second);
  EXPECT_FALSE(is_embedded(test::solid(oval), kWhole));
}

// The least radius of curvature of the ellipse is less than its shorter semi-axis.
TEST(ArcLemma, of_an_ellipse_the_least_radius_of_curvature_counts) {
  for (const double share : {0x1p-31, -0x1p-31}) {
    EXPECT_TRUE(is_embedded(test::solid(uneven_elbow(4, 3, 4 * (1 - 3 * 0x1p-31), share)), kWhole));
    EXPECT_FALSE(
        is_embedded(test::solid(uneven_elbow(4, 3, 4 * (1 - .5 * 0x1p-31), share)), kWhole));
  }
  EXPECT_FALSE(
      is_embedded(test::solid(uneven_elbow(4, 3, 4 * (1 - 1.5 * 0x1p-31), -0x1p-31)), kWhole));
}

TEST(ArcLemma, another_piece_has_no_arc) {
  EXPECT_FALSE(is_embedded(test::solid(test::elbow_of_bezier(4, 3, 1)), kWhole));
  const ParameterInterval all{0, 1};
  EXPECT_FALSE(are_apart(test::solid(test::cylinder_of_bezier({4, -3, 0}, {4, 0, 0}, 1)),
                         test::solid(test::elbow(4, 3, 1)), {kEndToStart}, all, all));
  EXPECT_FALSE(are_apart(test::solid(pipe_to(4, 1)), test::solid(test::elbow_of_bezier(4, 3, 1)),
                         {kEndToStart}, all, all));
  EXPECT_FALSE(
      are_apart(test::solid(pipe_to(4, 1)), test::ball({4, 1, 0}, 1), {kEndToStart}, all, all));
}

TEST(ArcLemma, a_line_has_no_discs_where_it_has_no_length) {
  RingedSurface none = pipe_to(4, 1);
  std::get<LineSpine>(none.spine).from = std::get<LineSpine>(none.spine).to;
  const ParameterInterval all{0, 1};
  EXPECT_TRUE(are_apart(test::solid(pipe_to(4, 1)), test::solid(test::elbow(4, 2, 1)),
                        {kEndToStart}, all, all));
  EXPECT_FALSE(
      are_apart(test::solid(none), test::solid(test::elbow(4, 2, 1)), {kEndToStart}, all, all));
}

TEST(ArcLemma, joined_parts_are_apart_just_where_the_bend_is_less_than_half_a_turn) {
  const auto joined = [](double angle, double radius, const ParameterInterval& t) {
    return are_apart(test::solid(pipe_to(4, radius)), test::solid(test::elbow(4, angle, radius)),
                     {kEndToStart}, {0, 1}, t);
  };
  const auto covers = [](double angle, double to) {
    return std::vector<DiscPairs>{{{0, 1}, {0, to}, {}},
                                  {{0, 1}, {to, 1}, Vec3(-1, angle > pi ? .125 : 0, 0)}};
  };
  EXPECT_TRUE(joined(3.14, 1, {0, 1}));
  EXPECT_TRUE(joined(3.14, 3.999, {0, 1}));
  EXPECT_FALSE(joined(3.14, 4, {0, 1}));
  EXPECT_FALSE(joined(3.15, 1, {0, 1}));
  EXPECT_FALSE(joined(5, 1, {0, 1}));
  // By what the stretch turns, not the bend.
  const Solid pipe = test::solid(pipe_to(4, 1)), bend = test::solid(test::elbow(4, 4, 1));
  for (const auto& [to, holds] : {std::pair{.75, true}, {.8125, false}}) {  // 3 and 3.25
    const ClearanceClaim claim{0, 1, Verdict::proved, 0, covers(4, to), {}};
    EXPECT_EQ(follows(pipe, bend, {kEndToStart}, claim), holds);
  }
}

// By less than half a turn by so much more than the ellipse's semi-axes differ.
TEST(ArcLemma, half_a_turn_of_an_ellipse_lacks_what_its_axes_differ_by) {
  const ParameterInterval all{0, 1};
  const auto joined = [&](double angle, double share) {
    return are_apart(test::solid(pipe_to(4, 2)), test::solid(uneven_elbow(4, angle, 2, share)),
                     {kEndToStart}, all, all);
  };
  for (const double share : {0x1p-31, -0x1p-31}) {
    EXPECT_TRUE(joined(pi - 0x1p-27, share));  // it takes 2^-28
    EXPECT_FALSE(joined(pi - 0x1p-30, share));
    EXPECT_TRUE(joined(pi - 0x1p-30, 0));
  }
}

// Both ways, and of bends on both sides.
TEST(ArcLemma, what_is_behind_a_joint_and_before_it_may_be_bent) {
  const ParameterInterval all{0, 1};
  const Solid first = test::solid(test::elbow(4, 3, 3.9));
  RingedSurface on = test::elbow(4, 2, 3.9);  // goes on around the same axis
  std::get<ArcSpine>(on.spine).start = first.pieces().front().end.center;
  EXPECT_TRUE(are_apart(first, test::solid(on), {kEndToStart}, all, all));
  EXPECT_TRUE(are_apart(test::solid(on), first, {{End::start, End::end}}, all, all));
  EXPECT_FALSE(are_apart(first, test::solid(on), {}, all, all));
  EXPECT_FALSE(
      are_apart(test::solid(test::elbow(4, 3.2, 3.9)), test::solid(on), {kEndToStart}, all, all));
}

TEST(ArcLemma, of_a_chain_is_about_neighbours) {
  const ParameterInterval a{0, 1}, b{1, 2}, c{2, 3};
  const auto chain = [](double angle) {
    RingedSurface bend = test::elbow(4, angle, 3.9);
    const Vec3 along = bend.end.normal, from = bend.end.center;
    return test::solid(pipe_to(4, 3.9), bend, test::cylinder(from, from + 30 * along, 3.9));
  };
  const std::vector<DiscPairs> leaves{{a, a, {}}, {b, b, {}}, {c, c, {}}, {a, b, {}}, {b, c, {}}};
  auto all = leaves, none = leaves;
  all.push_back({a, c, Vec3(-1, 0, 0)});
  none.push_back({a, c, {}});  // of no neighbours nothing is said
  EXPECT_TRUE(is_embedded(chain(3.14), all));
  EXPECT_FALSE(is_embedded(chain(3.14), none));
  EXPECT_FALSE(is_embedded(chain(3.15), all));
}

// What is left out at a joint is as wide as it is off, and the stretches are longer than that.
TEST(ArcLemma, counts_how_far_the_discs_of_a_joint_are_off) {
  const RingedSurface pipe = test::cylinder({-8, 0, 0}, {0, 0, 0}, 1);
  const auto goes_on = [&](double gap, double turn, double length) {
    const Vec3 along(std::cos(turn), std::sin(turn), 0), from(gap, 0, 0);
    const Vec3 between(std::cos(turn / 2), std::sin(turn / 2), 0);
    const ClearanceClaim claim{0,
                               1,
                               Verdict::proved,
                               0,
                               {{{1 - length, 1}, {0, length}, {}},
                                {{0, 1 - length}, {0, 1}, between},
                                {{1 - length, 1}, {length, 1}, between}},
                               {}};
    return follows(test::solid(pipe), test::solid(test::cylinder(from, from + 8 * along, 1)),
                   {kEndToStart}, claim);
  };
  EXPECT_TRUE(goes_on(0, 0, 0x1p-20));
  for (const double gap : {-.25, .25}) {
    EXPECT_TRUE(goes_on(gap, 0, 0x1p-4)) << "stretches of .5";
    EXPECT_FALSE(goes_on(gap, 0, 0x1p-5)) << "stretches of .25";
  }
  // By at most .4 and the gap, where stretches of .5 and of 1 advance by more than .46 and .92.
  EXPECT_TRUE(goes_on(0, .25, 0x1p-4));
  EXPECT_FALSE(goes_on(.125, .25, 0x1p-4));
  EXPECT_TRUE(goes_on(.5, .25, 0x1p-3));
  EXPECT_FALSE(goes_on(.55, .25, 0x1p-3));
}

// An elbow advances by at least 2.99 of its chord, 5.45.
TEST(ArcLemma, counts_how_far_arcs_are_off_as_they_advance) {
  const auto apart = [](double from, double length) {
    RingedSurface pipe = pipe_to(4, 1);
    pipe.spine = LineSpine{Vec3(4, from - length, 0), Vec3(4, from, 0)};
    return are_apart(test::solid(pipe), test::solid(test::elbow(4, 1.5, 1)), {kEndToStart}, {0, 1},
                     {0, 1});
  };
  EXPECT_TRUE(apart(0, 30));
  EXPECT_TRUE(apart(2.98, 30));
  EXPECT_FALSE(apart(3, 30));
  EXPECT_TRUE(apart(-2.98, 30));
  EXPECT_FALSE(apart(-2.98, 2.97)) << "so long is the pipe";
  const Solid back = test::solid(test::cylinder({4, 0, 0}, {4, -8, 0}, 1));
  EXPECT_FALSE(are_apart(test::solid(pipe_to(4, 1)), back, {kEndToStart}, {0, 1}, {0, 1}));
}

// The first advances by 1 along its discs' normal, and by 9 to the side, fastest where it begins.
TEST(ClearanceClaim, of_joined_parts_is_about_discs_that_move_askew) {
  const RationalRingedSurface askew{
      {Vec3(-1, -9, 0), Vec3(-.7, 0, 0), Vec3(-.35, 0, 0), Vec3(0, 0, 0)},
      {1, 1, 1, 1},
      {{1, 0, 0, 0}, {1, 0, 0, 0}}};
  const Solid first = test::solid(RationalRingedTube{
      {Vec3(-1, -9, 0), -Vec3::UnitX(), 1}, {Vec3(0, 0, 0), Vec3::UnitX(), 1}, askew});
  const ParameterInterval all{0, 1};
  const auto apart = [&](double gap) {
    return are_apart(first, test::solid(test::cylinder({-gap, 0, 0}, {30, 0, 0}, 1)), {kEndToStart},
                     all, all);
  };
  EXPECT_TRUE(apart(.125));
  EXPECT_FALSE(apart(1.1)) << "it begins behind all of the first";
}

// Its discs meet on the axis of the bend.
TEST(EmbeddedClaim, of_a_piece_that_does_not_advance_does_not_follow) {
  RingedSurface bent = test::elbow_of_bezier(4, .75, 1);
  for (const auto& [radius, holds] : {std::pair{1., true}, {5., false}}) {
    bent.radius = BezierRadius{{radius, 1.25 * radius, radius}};  // nothing follows by lemma 1
    EXPECT_EQ(is_embedded(test::solid(bent), kWhole), holds);
  }
}

}  // namespace
}  // namespace dupin::verification
