#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "support/cyclide_cases.h"
#include "support/paper_surfaces.h"
#include "verification/claims/pair_claims.h"

namespace dupin::verification {
namespace {

using std::numbers::pi;

const JoinedEnds kEndToStart{End::end, End::start}, kStartToEnd{End::start, End::end};

const RegularClaim kRegular{Verdict::proved, .5, {}, {}};

EmbeddedClaim embedded(const std::vector<DiscPairs>& leaves) {
  return {Verdict::proved, leaves, {}};
}

EmbeddedClaim overlapping(const Vec3& point, const ParameterInterval& first,
                          const ParameterInterval& second) {
  return {Verdict::refuted, {}, Overlap{point, first, second}};
}

ClearanceClaim clearance(double distance, const std::vector<DiscPairs>& leaves) {
  return {0, 1, Verdict::proved, distance, leaves, {}};
}

ClearanceClaim common_point(Verdict verdict, const Overlap& overlap) {
  return {0, 1, verdict, 0, {}, overlap};
}

DiscPairs whole(const std::optional<Vec3>& direction = {}) { return {{0, 1}, {0, 1}, direction}; }

// Of half a torus on a Bezier curve, in so many stretches: neighbours turn by less than a right
// angle, others have the half-plane between them.
std::vector<DiscPairs> leaves_of_half_torus(int stretches) {
  std::vector<DiscPairs> leaves;
  const auto stretch = [=](int i) {
    return ParameterInterval{double(i) / stretches, double(i + 1) / stretches};
  };
  for (int i = 0; i < stretches; ++i) {
    for (int j = i; j < stretches; ++j) {
      const double middle = (i + j + 1) / 2. / stretches;
      const double between = 2 * std::atan2(middle, 1 - middle);
      leaves.push_back({stretch(i), stretch(j), {}});
      if (j > i + 1) {
        leaves.back().direction = Vec3(-std::sin(between), std::cos(between), 0);
      }
    }
  }
  return leaves;
}

TEST(EmbeddedClaim, of_a_straight_tube_needs_one_leaf) {
  const Solid pipe = test::solid(test::cylinder({0, 0, 0}, {5, 1, 2}, 3));
  EXPECT_TRUE(follows(pipe, embedded({whole()}), kRegular));
  EXPECT_FALSE(follows(pipe, embedded({}), kRegular));
}

TEST(EmbeddedClaim, needs_the_part_to_be_proved_regular) {
  const Solid pipe = test::solid(test::cylinder({0, 0, 0}, {5, 1, 2}, 3));
  for (const Verdict verdict : {Verdict::undecided, Verdict::refuted}) {
    EXPECT_FALSE(follows(pipe, embedded({whole()}), {verdict, .5, {}, {}}));
  }
}

TEST(EmbeddedClaim, of_half_a_torus_follows_from_stretches_and_planes) {
  const Solid solid = test::solid(test::elbow_of_bezier(4, pi, 1));
  const std::vector<DiscPairs> leaves = leaves_of_half_torus(6);
  EXPECT_TRUE(follows(solid, embedded(leaves), kRegular));
  EXPECT_FALSE(follows(solid, embedded({whole()}), kRegular));  // it turns by more than pi / 2
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    auto fewer = leaves;
    fewer.erase(fewer.begin() + std::ptrdiff_t(i));
    EXPECT_FALSE(follows(solid, embedded(fewer), kRegular)) << i;
    if (leaves[i].direction) {
      auto turned = leaves, none = leaves, bent = leaves;
      turned[i].direction = -*leaves[i].direction;
      none[i].direction.reset();
      bent[i].direction = Vec3::UnitZ();
      EXPECT_FALSE(follows(solid, embedded(turned), kRegular)) << i;
      EXPECT_FALSE(follows(solid, embedded(bent), kRegular)) << i;
      EXPECT_FALSE(follows(solid, embedded(none), kRegular)) << i;
    }
  }
}

TEST(EmbeddedClaim, needs_leaves_for_all_pairs_but_not_twice) {
  const Solid pipe = test::solid(test::cylinder({0, 0, 0}, {5, 1, 2}, 3));
  const ParameterInterval a{0, .5}, b{.5, 1};
  EXPECT_TRUE(follows(pipe, embedded({{a, a, {}}, {a, b, {}}, {b, b, {}}}), kRegular));
  EXPECT_FALSE(follows(pipe, embedded({{a, a, {}}, {b, b, {}}}), kRegular));
  EXPECT_FALSE(follows(pipe, embedded({{a, a, {}}, {a, {.5, .9375}, {}}, {b, b, {}}}), kRegular));
  EXPECT_FALSE(follows(pipe, embedded({{b, a, {}}}), kRegular));
  EXPECT_FALSE(follows(pipe, embedded({whole(), {{.5, .5}, b, {}}}), kRegular));  // an empty leaf
  EXPECT_FALSE(follows(pipe, embedded({whole(), {{0, 2}, b, {}}}), kRegular));    // beyond the end
}

// With kappa R < 1 - margin only, a radius that varies might meet the disc of before.
TEST(EmbeddedClaim, of_a_tube_that_swells_needs_the_margin) {
  RingedSurface bulb = test::elbow(4, 1, 1);
  bulb.radius = BezierRadius{{1, 1.5, 1}};  // at most 1.25; control points say up to 1.5
  const Solid solid = test::solid(bulb);
  EXPECT_TRUE(follows(solid, embedded({whole()}), {Verdict::proved, .4, {}, {}}));
  RingedSurface bent = test::elbow_of_bezier(4, 1.5, 1);  // by more than lemma 2 takes
  bent.radius = BezierRadius{{1, 2, 1}};
  EXPECT_TRUE(follows(test::solid(bent), embedded({whole()}), {Verdict::proved, .6, {}, {}}));
  EXPECT_FALSE(follows(test::solid(bent), embedded({whole()}), {Verdict::proved, .1, {}, {}}));
}

// Bent by more than lemma 2 takes.
TEST(EmbeddedClaim, of_a_tube_that_only_grows_or_falls_needs_no_margin) {
  RingedSurface bent = test::elbow_of_bezier(4, 1.5, 1);
  for (const RadiusLaw& law : {RadiusLaw(LinearRadius{1, 2}), RadiusLaw(LinearRadius{2, 1}),
                               RadiusLaw(CyclideRadius{1, 2}), RadiusLaw(CyclideRadius{2, 1})}) {
    bent.radius = law;
    EXPECT_TRUE(follows(test::solid(bent), embedded({whole()}), {Verdict::proved, .1, {}, {}}));
  }
}

TEST(EmbeddedClaim, of_an_elliptic_tube_that_swells_needs_the_margin_of_its_larger_axis) {
  EllipticTube tube;
  const RingedSurface about = test::elbow_of_bezier(16, 1.5, 3);
  tube.start = about.start;
  tube.end = about.end;
  tube.spine = about.spine;
  tube.first = BezierRadius{{2, 2.25, 2}};
  tube.second = BezierRadius{{3, 2.5, 3}};
  tube.axis = Vec3::UnitZ();
  const Solid solid = test::solid(tube);
  EXPECT_TRUE(follows(solid, embedded({whole()}), {Verdict::proved, .4, {}, {}}));
  EXPECT_FALSE(follows(solid, embedded({whole()}), {Verdict::proved, .15, {}, {}}));
}

TEST(EmbeddedClaim, of_a_chain_advances_across_its_joints) {
  const Solid chain = test::solid(test::cylinder({4, -3, 0}, {4, 0, 0}, 1), test::elbow(4, .5, 1));
  const std::vector<DiscPairs> leaves{
      {{0, 1}, {0, 1}, {}}, {{0, 1}, {1, 2}, {}}, {{1, 2}, {1, 2}, {}}};
  EXPECT_TRUE(follows(chain, embedded(leaves), kRegular));
  EXPECT_FALSE(follows(chain, embedded({{{0, 2}, {0, 2}, {}}}), kRegular));  // over both pieces
  const Solid tight =
      test::solid(test::cylinder_of_bezier({1.5, -3, 0}, {1.5, 0, 0}, 1), test::elbow(1.5, 1.2, 1));
  EXPECT_FALSE(follows(tight, embedded(leaves), kRegular));
}

// Lemma 2 counts the turn at the joint: as thin as these are, their rings are hardly off.
TEST(EmbeddedClaim, of_a_chain_that_turns_back_at_its_joint_does_not_follow) {
  const std::vector<DiscPairs> leaves{
      {{0, 1}, {0, 1}, {}}, {{0, 1}, {1, 2}, {}}, {{1, 2}, {1, 2}, {}}};
  for (const auto& [turn, follows_then] :
       {std::pair(0., true), {.5, true}, {1.2, false}, {2.5, false}, {pi, false}}) {
    const Vec3 on(5 + 4 * std::cos(turn), 4 * std::sin(turn), 0);
    const Solid chain = test::solid(test::cylinder_of_bezier({0, 0, 0}, {5, 0, 0}, .015),
                                    test::cylinder_of_bezier({5, 0, 0}, on, .015));
    EXPECT_EQ(follows(chain, embedded(leaves), kRegular), follows_then) << turn;
  }
}

// Between the first and the last of four straight pieces there is only the way on which the chain
// closes; where they overlap, their discs are not those of one joint.
TEST(EmbeddedClaim, goes_around_only_where_the_chain_closes) {
  const Vec3 up = Vec3::UnitY();
  const auto chain = [](const auto& last) {
    return test::part(test::cylinder_of_bezier({0, 0, 0}, {3, 0, 0}, 1),
                      test::cylinder({0, 100, 0}, {3, 100, 0}, 1),
                      test::cylinder({0, 200, 0}, {3, 200, 0}, 1), last);
  };
  const ParameterInterval a{0, 1}, b{1, 2}, c{2, 3}, d{3, 4};
  const EmbeddedClaim claim = embedded({{a, a, {}},
                                        {a, b, up},
                                        {a, c, up},
                                        {a, d, {}},
                                        {b, b, {}},
                                        {b, c, up},
                                        {b, d, -up},
                                        {c, c, {}},
                                        {c, d, -up},
                                        {d, d, {}}});
  CertifiedPart straight = chain(test::cylinder({-3, 0, 0}, {0, 0, 0}, 1)),
                over = chain(test::cylinder({1, 0, 0}, {4, 0, 0}, 1)),
                bent = chain(test::elbow(1.5, 1.2, 1));
  EXPECT_FALSE(follows(Solid(straight), claim, kRegular));
  for (CertifiedPart* const part : {&straight, &over, &bent}) {
    std::get<Chain>(part->shape).closed = true;
  }
  EXPECT_TRUE(follows(Solid(straight), claim, kRegular));
  EXPECT_FALSE(follows(Solid(over), claim, kRegular));
  EXPECT_FALSE(follows(Solid(bent), claim, kRegular));
}

// A loop that crosses itself after its first eighth, of which all is true that is said. Then a leaf
// whose second interval begins before its first says nothing of the way between the two.
TEST(EmbeddedClaim, needs_leaves_that_begin_in_the_order_of_the_way) {
  RingedSurface loop;
  loop.spine = BezierSpine{{Vec3(0, 0, 0), Vec3(30, 20, 0), Vec3(-20, 20, 0), Vec3(10, 0, 0)}, {}};
  loop.radius = ConstantRadius{.01};
  constexpr int kCells = 64, kFirst = 3;  // cells before the loop crosses itself, at .067
  const auto cell = [](int i) {
    return ParameterInterval{double(i) / kCells, double(i + 1) / kCells};
  };
  const auto middle = [&](int i) { return evaluate(loop.spine, (i + .5) / kCells).position; };
  std::vector<DiscPairs> leaves;
  for (int i = 0; i < kFirst; ++i) {
    for (int j = i; j < kCells; ++j) {
      leaves.push_back({cell(i), cell(j), {}});
      if (j > i + 1) {
        leaves.back().direction = middle(j) - middle(i);
      }
    }
  }
  const Solid solid = test::solid(loop);
  const ParameterInterval rest{double(kFirst) / kCells, 1};
  leaves.push_back({rest, {0, 1}, {}});
  EXPECT_FALSE(follows(solid, embedded(leaves), kRegular));
  // The same leaves are enough of the loop's first quarter, going on straight.
  RingedSurface open = loop;
  open.spine = BezierSpine{{Vec3(0, 0, 0), Vec3(30, 20, 0), Vec3(60, 30, 0), Vec3(90, 30, 0)}, {}};
  for (DiscPairs& leaf : leaves) {
    leaf.direction = leaf.direction ? std::optional<Vec3>(Vec3::UnitX()) : std::nullopt;
  }
  leaves.back() = {rest, rest, {}};
  EXPECT_TRUE(follows(test::solid(open), embedded(leaves), kRegular));
}

TEST(EmbeddedClaim, of_a_cyclide_follows_by_what_it_advances) {
  const PeArc arc = PeArc::from(test::sphere(0, 0, 0, 1), test::direction(Vec3::UnitX(), .1),
                                test::sphere(4, 1, .5, .8));
  EXPECT_TRUE(follows(test::solid(test::cyclide_piece(arc)), embedded({whole()}), kRegular));
  const PeArc half = PeArc::from(test::sphere(4, 0, 0, 1), test::direction(Vec3::UnitY(), 0),
                                 test::sphere(-2, std::sqrt(12), 0, 1));
  EXPECT_FALSE(follows(test::solid(test::cyclide_piece(half)), embedded({whole()}), kRegular));
}

// Once and a half around the torus: what is passed twice overlaps.
TEST(EmbeddedClaim, is_refuted_by_a_point_in_two_discs) {
  const Solid solid = test::solid(test::elbow(4, 3 * pi, 1));
  const Vec3 inside(0, 4, 0);  // at t = 1/6 and t = 5/6
  const ParameterInterval first{.15625, .1875}, second{.8125, .84375};
  EXPECT_TRUE(follows(solid, overlapping(inside, first, second), kRegular));
  EXPECT_TRUE(follows(solid, overlapping(Vec3(0, 4, .5), second, first), kRegular));
  EXPECT_FALSE(follows(solid, overlapping(Vec3(0, 4, 1.1), first, second), kRegular));
  EXPECT_FALSE(follows(solid, overlapping(inside, {.25, .28125}, second), kRegular));
  EXPECT_FALSE(follows(solid, overlapping(inside, first, {.75, .78125}), kRegular));
  EXPECT_FALSE(follows(solid, overlapping(inside, first, first), kRegular));
  EXPECT_FALSE(follows(solid, overlapping(inside, {.125, .25}, {.1875, .875}), kRegular));
  EXPECT_FALSE(follows(solid, overlapping(inside, first, {5. / 6, 5. / 6}), kRegular));
  EXPECT_FALSE(follows(solid, {Verdict::refuted, {}, {}}, kRegular));
}

// The plane of the disc turns round at a cusp, and passes no point on its way.
TEST(EmbeddedClaim, is_not_refuted_by_a_disc_that_turns_round_in_a_cusp) {
  RingedSurface there_and_back = test::cylinder({0, 0, 0}, {9, 0, 0}, 1);
  there_and_back.spine = BezierSpine{{Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 0, 0)}, {}};
  const Solid cusp = test::solid(there_and_back), ball = test::ball({5.5, 0, 0}, .3);
  const Overlap beyond{Vec3(5.25, 0, 0), {.46875, .53125}, {0, 1}};
  EXPECT_FALSE(follows(cusp, ball, {}, common_point(Verdict::proved, beyond)));
  const Solid there = test::solid(test::cylinder_of_bezier({0, 0, 0}, {10, 0, 0}, 1));
  EXPECT_TRUE(follows(there, ball, {}, common_point(Verdict::proved, beyond)));
}

// That a flat end is touched is told of two parts, not of one.
TEST(EmbeddedClaim, is_not_refuted_by_what_touches_a_flat_end) {
  const Solid chain = test::solid(test::cylinder({0, 0, 0}, {4, 0, 0}, 1),
                                  test::cylinder({-2, .5, 0}, {3, .5, 0}, 1));
  const Vec3 on(0, .5, 0), behind(.1, .5, 0);
  const ParameterInterval end{0, 0}, after{0, .125}, across{1.25, 1.5};
  EXPECT_TRUE(follows(chain, overlapping(behind, after, across), kRegular));
  EXPECT_TRUE(follows(chain, overlapping(behind, across, after), kRegular));
  EXPECT_FALSE(follows(chain, overlapping(on, end, across), kRegular));
  EXPECT_FALSE(follows(chain, overlapping(on, across, end), kRegular));
}

// A corner is said of what is separated by nothing else, and of that only.
TEST(ClearanceClaim, has_a_corner_or_a_distance) {
  const auto claim = [](Verdict verdict, double distance, double corner) {
    ClearanceClaim result{0, 1, verdict, distance, {}, {}};
    result.corner = corner;
    return result;
  };
  EXPECT_TRUE(has_form(claim(Verdict::proved, 0, 0.5)));
  EXPECT_TRUE(has_form(claim(Verdict::proved, 1, 0)));
  EXPECT_FALSE(has_form(claim(Verdict::proved, 1, 0.5)));
  EXPECT_TRUE(has_form(claim(Verdict::undecided, 0, 0)));
  EXPECT_FALSE(has_form(claim(Verdict::undecided, 0, 0.5)));
  EXPECT_FALSE(has_form(claim(Verdict::refuted, 0, 0.5)));
  ClearanceClaim met = claim(Verdict::proved, 0, 0.5);
  met.overlap.emplace();
  EXPECT_FALSE(has_form(met));
}

TEST(ClearanceClaim, of_parallel_pipes_is_the_slab_between_them) {
  const Solid low = test::solid(test::cylinder({0, 0, 0}, {9, 0, 0}, 1)),
              high = test::solid(test::cylinder({2, 0, 5}, {7, 0, 5}, 2));
  const Vec3 up(0, 0, 3);  // of any length
  EXPECT_TRUE(follows(low, high, {}, clearance(1.999, {whole(up)})));
  EXPECT_FALSE(follows(low, high, {}, clearance(2.001, {whole(up)})));
  EXPECT_TRUE(follows(high, low, {}, clearance(1.999, {whole(-up)})));
  EXPECT_FALSE(follows(low, high, {}, clearance(1.999, {whole(-up)})));
  EXPECT_FALSE(follows(low, high, {}, clearance(1.999, {whole(Vec3::UnitY())})));
  EXPECT_FALSE(follows(low, high, {}, clearance(1.999, {whole(Vec3::Zero())})));
  EXPECT_FALSE(follows(low, high, {}, clearance(0, {whole(up)})));
  EXPECT_FALSE(follows(low, high, {}, clearance(-1, {whole(up)})));
  EXPECT_FALSE(
      follows(low, high, {}, clearance(std::numeric_limits<double>::quiet_NaN(), {whole(up)})));
  ClearanceClaim refuted = clearance(1.5, {whole(up)});
  refuted.verdict = Verdict::refuted;
  EXPECT_FALSE(follows(low, high, {}, refuted));
}

TEST(ClearanceClaim, of_pipes_that_touch_does_not_follow) {
  const Solid low = test::solid(test::cylinder({0, 0, 0}, {9, 0, 0}, 1)),
              high = test::solid(test::cylinder({2, 0, 3}, {7, 0, 3}, 2));
  const std::vector<JoinedEnds> joined{kEndToStart};
  EXPECT_FALSE(follows(low, high, joined, clearance(0, {whole(Vec3::UnitZ())})));
  EXPECT_TRUE(follows(low, test::solid(test::cylinder({2, 0, 3.001}, {7, 0, 3.001}, 2)), joined,
                      clearance(0, {whole(Vec3::UnitZ())})));
}

// A ball in the rim of a horn, beyond the disc that the rim leans over.
TEST(ClearanceClaim, of_a_hollow_chain_is_that_of_its_rims) {
  CertifiedPart part = test::part(test::cyclide_piece(PeArc::from(
      test::sphere(0, 0, 0, 4), test::direction(Vec3::UnitX(), .5), test::sphere(6, 0, 0, 7))));
  const Solid ball = test::ball({2.8, 0, 5.5}, .1);
  const Vec3 along = Vec3::UnitX();
  EXPECT_TRUE(follows(Solid(part), ball, {}, clearance(.15, {whole(along)})));
  std::get<Chain>(part.shape).wall = 1;
  EXPECT_FALSE(follows(Solid(part), ball, {}, clearance(.15, {whole(along)})));
  const Solid further = test::ball({3.2, 0, 5.5}, .1);
  EXPECT_TRUE(follows(Solid(part), further, {}, clearance(.05, {whole(along)})));
}

TEST(ClearanceClaim, of_what_is_joined_to_a_rim_that_reaches_into_it_does_not_follow) {
  CertifiedPart part = test::part(test::cyclide_piece(PeArc::from(
      test::sphere(0, 0, 0, 4), test::direction(Vec3::UnitX(), .5), test::sphere(6, 0, 0, 7))));
  std::get<Chain>(part.shape).wall = 1;
  const Solid horn(part), pipe = test::solid(test::cylinder({2.5, 0, 0}, {9, 0, 0}, 6));
  const ClearanceClaim claim = clearance(0, {whole()});
  EXPECT_TRUE(follows(horn, pipe, {kEndToStart}, claim));
  EXPECT_FALSE(follows(horn, pipe, {{End::end, End::start, false}}, claim));
}

TEST(ClearanceClaim, needs_leaves_for_all_pairs) {
  const Solid low = test::solid(test::cylinder({0, 0, 0}, {9, 0, 0}, 1)),
              high = test::solid(test::cylinder({2, 0, 5}, {7, 0, 5}, 2));
  const Vec3 up(0, 0, 1);
  const ParameterInterval a{0, .5}, b{.5, 1};
  EXPECT_TRUE(
      follows(low, high, {}, clearance(1, {{a, a, up}, {b, a, up}, {a, b, up}, {b, b, up}})));
  EXPECT_FALSE(follows(low, high, {}, clearance(1, {{a, a, up}, {b, a, up}, {b, b, up}})));
  EXPECT_FALSE(
      follows(low, high, {}, clearance(1, {{a, a, up}, {b, a, -up}, {a, b, up}, {b, b, up}})));
  EXPECT_FALSE(follows(low, high, {}, clearance(1, {})));
  EXPECT_FALSE(follows(low, high, {}, clearance(1, {whole()})));  // there is no joint
}

TEST(ClearanceClaim, of_balls_is_the_distance_of_their_surfaces) {
  const Solid a = test::ball({0, 0, 0}, 1), b = test::ball({3, 4, 0}, 2);
  const Vec3 across(3, 4, 0);
  EXPECT_TRUE(follows(a, b, {}, clearance(1.999, {whole(across)})));
  EXPECT_FALSE(follows(a, b, {}, clearance(2.001, {whole(across)})));
  EXPECT_FALSE(follows(a, b, {}, clearance(1.999, {whole(Vec3::UnitX())})));
}

TEST(ClearanceClaim, of_balls_is_never_more_than_their_distance) {
  const Solid a = test::ball({0, 0, 0}, 1);
  for (const Vec3& across : {Vec3(1, 0, 0), Vec3(1, 1, 1), Vec3(1, 2, 3), Vec3(3, 7, -1)}) {
    const Solid b = test::ball(4 * across, 1);
    const double distance = 4 * across.norm() - 2;
    EXPECT_TRUE(follows(a, b, {}, clearance(distance * (1 - 0x1p-48), {whole(across)})));
    EXPECT_FALSE(follows(a, b, {}, clearance(std::nextafter(distance, 99), {whole(across)})));
  }
}

// A straight pipe into a bend of radius R and angle a: lemma 2 asks for R (1 - a^2 / 2) > r, and
// the cells lose nothing. r is the largest radius on the way.
TEST(ClearanceClaim, of_joined_parts_follows_just_where_the_lemma_says) {
  const auto connected = [](double bend, double angle, const RadiusLaw& before,
                            const RadiusLaw& after) {
    RingedSurface pipe = test::cylinder_of_bezier({bend, -3, 0}, {bend, 0, 0}, 1);
    RingedSurface elbow = test::elbow(bend, angle, 1);
    pipe.radius = before;
    elbow.radius = after;
    return follows(test::solid(pipe), test::solid(elbow), {kEndToStart}, clearance(0, {whole()}));
  };
  const LinearRadius growing{1, 2}, falling{2, 1};
  const ConstantRadius one{1}, two{2};
  for (const double angle : {.5, .7, .9}) {
    const double least = 1 / (1 - angle * angle / 2);
    EXPECT_TRUE(connected(least * (1 + 1e-9), angle, one, one));
    EXPECT_FALSE(connected(least * (1 - 1e-9), angle, one, one));
    for (const auto& [before, after] :
         {std::pair<RadiusLaw, RadiusLaw>{two, one}, {one, two}, {one, growing}, {falling, one}}) {
      EXPECT_TRUE(connected(2 * least * (1 + 1e-9), angle, before, after));
      EXPECT_FALSE(connected(2 * least * (1 - 1e-9), angle, before, after));
    }
  }
}

TEST(ClearanceClaim, with_a_common_point_proves_that_unjoined_parts_are_connected) {
  const Solid along = test::solid(test::cylinder({-5, 0, 0}, {5, 0, 0}, 1)),
              across = test::solid(test::cylinder({0, -5, 1}, {0, 5, 1}, 1)),
              ball = test::ball({0, 0, -1}, 1);
  const Overlap between{Vec3(0, 0, .5), {.4375, .5625}, {.4375, .5625}};
  EXPECT_TRUE(follows(along, across, {}, common_point(Verdict::proved, between)));
  EXPECT_FALSE(follows(along, across, {}, common_point(Verdict::refuted, between)));
  // Joined parts must have nothing in common.
  const std::vector<JoinedEnds> joined{kEndToStart};
  EXPECT_TRUE(follows(along, across, joined, common_point(Verdict::refuted, between)));
  EXPECT_FALSE(follows(along, across, joined, common_point(Verdict::proved, between)));
  // It says nothing besides.
  ClearanceClaim more = common_point(Verdict::proved, between);
  more.distance = .5;
  EXPECT_FALSE(follows(along, across, {}, more));
  more = common_point(Verdict::proved, between);
  more.leaves = {whole()};
  EXPECT_FALSE(follows(along, across, {}, more));
  Overlap wrong = between;
  wrong.point = Vec3(0, 0, 1.25);  // outside of the first
  EXPECT_FALSE(follows(along, across, {}, common_point(Verdict::proved, wrong)));
  wrong.point = Vec3(0, 0, -.25);  // of the second
  EXPECT_FALSE(follows(along, across, {}, common_point(Verdict::proved, wrong)));
  wrong = between;
  wrong.first = {.5625, .6875};
  EXPECT_FALSE(follows(along, across, {}, common_point(Verdict::proved, wrong)));
  EXPECT_TRUE(follows(along, ball, {},
                      common_point(Verdict::proved, {Vec3(0, 0, -.5), {.4375, .5625}, {0, 1}})));
  EXPECT_FALSE(follows(along, ball, {},
                       common_point(Verdict::proved, {Vec3(0, 0, .5), {.4375, .5625}, {0, 1}})));
}

// All of the stretch's centres are nearer than the radius, not some.
TEST(ClearanceClaim, with_a_common_point_needs_short_stretches) {
  const Solid pipe = test::solid(test::cylinder({0, 0, 0}, {10, 0, 0}, 1)),
              ball = test::ball({.5, 0, 0}, 1);
  const Vec3 inside(.5, 0, 0);
  EXPECT_TRUE(follows(pipe, ball, {}, common_point(Verdict::proved, {inside, {0, .125}, {0, 1}})));
  EXPECT_FALSE(follows(pipe, ball, {}, common_point(Verdict::proved, {inside, {0, .75}, {0, 1}})));
  EXPECT_FALSE(
      follows(pipe, ball, {}, common_point(Verdict::proved, {inside, {.0625, .125}, {0, 1}})));
}

// Nothing is known of discs that are of two pieces, though it is of the first and the last.
TEST(ClearanceClaim, with_a_common_point_needs_stretches_of_one_piece) {
  const Solid chain = test::solid(test::cylinder({0, 0, 0}, {1, 0, 0}, 1),
                                  test::cylinder({1, 0, 0}, {2, 0, 0}, 1)),
              ball = test::ball({1, 0, 0}, 1);
  const Vec3 inside(.875, 0, 0);
  EXPECT_TRUE(follows(chain, ball, {}, common_point(Verdict::proved, {inside, {.75, 1}, {0, 1}})));
  EXPECT_FALSE(
      follows(chain, ball, {}, common_point(Verdict::proved, {inside, {.75, 1.25}, {0, 1}})));
}

// Of a cone no disc passes beyond its border, though later ones of the stretch are larger.
TEST(ClearanceClaim, with_a_common_point_is_about_the_least_radius) {
  const Solid cone = test::solid(test::cone({0, 0, 0}, {1, 0, 0}, 1, 3)),
              ball = test::ball({.5, 2.2, 0}, 1);
  const ParameterInterval middle{.25, .75};
  EXPECT_TRUE(
      follows(cone, ball, {}, common_point(Verdict::proved, {Vec3(.5, 1.3, 0), middle, {0, 1}})));
  EXPECT_FALSE(
      follows(cone, ball, {}, common_point(Verdict::proved, {Vec3(.5, 2.2, 0), middle, {0, 1}})));
}

// Their centres are known to lie in a box, which comes near to more than they do.
TEST(ClearanceClaim, with_a_common_point_of_a_cyclide_is_about_all_of_its_centres) {
  const PeArc arc = PeArc::from(test::sphere(4, 0, 0, 1), test::direction(Vec3::UnitY(), 0),
                                test::sphere(0, 4, 0, 1));
  const Solid bend = test::solid(test::cyclide_piece(arc));
  const auto found = [&](double along, const ParameterInterval& t) {
    const Vec3 point(along, along, 0);
    return follows(bend, test::ball(point, .5), {},
                   common_point(Verdict::proved, {point, t, {0, 1}}));
  };
  EXPECT_TRUE(found(2.8, {.46875, .53125}));
  for (const double beside : {1.5, 1.9, 3.7, 4.}) {
    EXPECT_FALSE(found(beside, {.25, .75}));
    EXPECT_FALSE(found(beside, {0, 1}));
  }
}

TEST(ClearanceClaim, of_joined_parts_has_no_way_through_a_ball) {
  const Solid pipe = test::solid(test::cylinder({4, -3, 0}, {4, 0, 0}, 1)),
              ball = test::ball({4, 1, 0}, 1);
  EXPECT_FALSE(follows(pipe, ball, {kEndToStart}, clearance(0, {whole()})));
}

// Only flat ends that touch: the point lies in the disc of the stored ring, border included.
TEST(ClearanceClaim, with_a_point_of_a_flat_end_connects_parts_that_touch) {
  const Solid before = test::solid(test::cylinder({-5, 0, 0}, {0, 0, 0}, 1)),
              after = test::solid(test::cylinder({0, 1, 0}, {5, 1, 0}, 1)),
              apart = test::solid(test::cylinder({1e-9, 1, 0}, {5, 1, 0}, 1));
  const Overlap touching{Vec3(0, 1, 0), {1, 1}, {0, 0}};
  EXPECT_TRUE(follows(before, after, {}, common_point(Verdict::proved, touching)));
  EXPECT_FALSE(follows(before, apart, {}, common_point(Verdict::proved, touching)));
  EXPECT_FALSE(follows(before, after, {},
                       common_point(Verdict::proved, {Vec3(0, 1.001, 0), {1, 1}, {0, 0}})));
  EXPECT_FALSE(
      follows(before, after, {}, common_point(Verdict::proved, {Vec3(0, 1, 0), {.5, .5}, {0, 0}})));
  // Parts that are joined touch anyhow.
  EXPECT_FALSE(follows(before, after, {kEndToStart}, common_point(Verdict::refuted, touching)));
}

TEST(ClearanceClaim, of_what_is_not_full_is_never_an_overlap) {
  const PeArc arc = PeArc::from(test::sphere(-3, 0, 0, 1), test::direction(Vec3::UnitX(), 0),
                                test::sphere(3, 0, 0, 1));
  CertifiedPart pipe = test::part(test::cyclide_piece(arc));
  const Solid ball = test::ball({0, 0, 0}, .5);
  const ClearanceClaim claim =
      common_point(Verdict::proved, {Vec3(0, 0, 0), {.4375, .5625}, {0, 1}});
  EXPECT_TRUE(follows(Solid(pipe), ball, {}, claim));
  std::get<Chain>(pipe.shape).wall = .25;  // the ball is in the bore
  EXPECT_FALSE(follows(Solid(pipe), ball, {}, claim));
}

TEST(ClearanceClaim, of_joined_parts_follows_by_the_way_through_the_joint) {
  const Solid pipe = test::solid(test::cylinder_of_bezier({4, -3, 0}, {4, 0, 0}, 1)),
              bend = test::solid(test::elbow(4, .5, 1)), tight = test::solid(test::elbow(4, 2, 1));
  const std::vector<JoinedEnds> joined{kEndToStart};
  EXPECT_TRUE(follows(pipe, bend, joined, clearance(0, {whole()})));
  EXPECT_FALSE(follows(pipe, bend, joined, clearance(.1, {whole()})));
  EXPECT_FALSE(follows(pipe, bend, {}, clearance(0, {whole()})));
  // Through the other ends the way is another one, along which the bend runs back.
  EXPECT_FALSE(follows(pipe, bend, {kStartToEnd}, clearance(0, {{{.5, 1}, {0, .5}, {}}})));
  EXPECT_FALSE(follows(pipe, tight, joined, clearance(0, {whole()})));
  EXPECT_TRUE(follows(pipe, tight, joined,
                      clearance(0, {{{0, 1}, {0, .25}, {}}, {{0, 1}, {.25, 1}, Vec3(0, 1, 0)}})));
}

// A straight pipe into discs of this radius whose centres have the velocity 1 + faster t, slide
// sideways at the rate `sliding` t, and whose normals turn about `axis` by the angle 2 atan of a
// polynomial.
bool leads_into(double faster, double sliding, const Vec3& axis, const std::vector<double>& turn,
                double radius) {
  const auto center = [=](double t) {
    return Vec3(t + faster * t * t / 2, sliding * t * t / 2, 0);
  };
  const Vec3 last = center(1), end_rate(1 + faster, sliding, 0);
  RationalRingedTube tube;
  tube.surface.center = {center(0), Vec3(1. / 3, 0, 0), last - end_rate / 3, last};
  tube.surface.radius = {radius, radius, radius, radius};
  for (const double c : turn) {
    tube.surface.rotation.push_back({1, c * axis.x(), c * axis.y(), c * axis.z()});
  }
  return follows(test::solid(test::cylinder({-3, 0, 0}, {0, 0, 0}, radius)), test::solid(tube),
                 {kEndToStart}, clearance(0, {whole()}));
}

// It is the slowest, the one that slides most and the one that turns most of a stretch that counts.
TEST(ClearanceClaim, of_joined_parts_is_about_the_worst_discs_on_the_way) {
  const std::vector<double> evenly{0, .05}, later{0, 0, .1};
  const Vec3 y = Vec3::UnitY(), z = Vec3::UnitZ();
  EXPECT_TRUE(leads_into(2, 0, z, evenly, 8));
  EXPECT_FALSE(leads_into(2, 0, z, evenly, 12)) << "they turn by 1.2 at the border";
  EXPECT_TRUE(leads_into(0, .5, y, {0, .25}, .1));
  EXPECT_FALSE(leads_into(0, 1.8, y, {0, .25}, .1));
  EXPECT_TRUE(leads_into(0, 0, z, later, 2));
  EXPECT_FALSE(leads_into(0, 0, z, later, 3.2));
}

// The spine turns back at its middle, where there is no disc.
TEST(ClearanceClaim, of_joined_parts_does_not_follow_where_there_is_no_disc) {
  RingedSurface back = test::cylinder({0, 0, 0}, {1, 0, 0}, 1);
  back.spine = BezierSpine{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 0)}, {}};
  EXPECT_FALSE(follows(test::solid(test::cylinder({-3, 0, 0}, {0, 0, 0}, 1)), test::solid(back),
                       {kEndToStart}, clearance(0, {whole()})));
}

}  // namespace
}  // namespace dupin::verification
