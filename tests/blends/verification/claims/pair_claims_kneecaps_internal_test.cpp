#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "dupin/blends/cyclide_tube.h"
#include "support/cyclide_cases.h"
#include "verification/claims/pair_claims.h"

// Of chains with kneecaps, which are more than their discs.
namespace dupin::verification {
namespace {

using std::numbers::pi;

const RegularClaim kRegular{Verdict::proved, .5, {}, {}};

EmbeddedClaim embedded(const std::vector<DiscPairs>& leaves) {
  return {Verdict::proved, leaves, {}};
}

ClearanceClaim clearance(double distance, const std::vector<DiscPairs>& leaves) {
  return {0, 1, Verdict::proved, distance, leaves, {}};
}

Solid chain(const std::vector<PeVector>& spheres) {
  CertifiedPart part;
  part.shape = kneecap_chain(spheres);
  return Solid(part);
}

// Pipes of radius 1 along the x axis to the origin and from there along the y axis: what the joint
// adds is a quarter of the unit ball, where x > 0 > y.
Solid corner() { return chain(test::corner_spheres(pi / 2)); }

const Vec3 kOut = Vec3(1, -1, 0);

std::vector<DiscPairs> pieces_apart(const Vec3& direction) {
  return {{{0, 1}, {0, 1}, direction}, {{1, 2}, {0, 1}, direction}};
}

TEST(PairClaimsOfKneecaps, reach_as_far_as_the_balls) {
  const IntervalVec out = numbers::interval_vec(kOut);
  for (const ParameterInterval& t : {ParameterInterval{0, 1}, {.5, 1}, {1, 1.5}, {1, 2}}) {
    const double found = furthest(corner(), t, out, 1);
    EXPECT_GE(found, std::sqrt(2));
    EXPECT_LE(found, std::sqrt(2) + 1e-12);
  }
  for (const ParameterInterval& t : {ParameterInterval{0, .5}, {1.5, 2}}) {
    EXPECT_LE(furthest(corner(), t, out, 1), 0);
  }
}

TEST(PairClaimsOfKneecaps, keep_a_distance_from_the_balls) {
  const double far = 1.25;  // of its centre from the origin
  const Solid near = test::ball(far * kOut.normalized(), .125);
  EXPECT_TRUE(follows(corner(), near, {}, clearance(.124, pieces_apart(kOut))));
  EXPECT_FALSE(follows(corner(), near, {}, clearance(.126, pieces_apart(kOut))));
  const auto other_way = [](const Vec3& w) {
    return std::vector<DiscPairs>{{{0, 1}, {0, 1}, -w}, {{0, 1}, {1, 2}, -w}};
  };
  EXPECT_TRUE(follows(near, corner(), {}, clearance(.124, other_way(kOut))));
  EXPECT_FALSE(follows(near, corner(), {}, clearance(.126, other_way(kOut))));
}

// As the discs are, from which alone a plane keeps apart what is inside of the joint's ball.
TEST(PairClaimsOfKneecaps, are_not_apart_from_what_is_in_a_ball) {
  const Solid inside = test::ball(.9 * kOut.normalized(), .1);
  EXPECT_FALSE(follows(corner(), inside, {}, clearance(1e-9, pieces_apart(kOut))));
  Chain smooth = kneecap_chain(test::corner_spheres(pi / 2));
  smooth.joints = Joints::smooth;
  CertifiedPart discs;
  discs.shape = smooth;
  EXPECT_TRUE(follows(Solid(discs), inside, {}, clearance(1e-9, pieces_apart(kOut))));
}

const JoinedEnds kEndToStart{End::end, End::start}, kStartToEnd{End::start, End::end};

// A way that reaches a kneecap says nothing of it.
TEST(PairClaimsOfKneecaps, are_joined_by_ways_that_stay_away_from_the_balls) {
  const Solid on = test::solid(test::cylinder({0, 4, 0}, {0, 7, 0}, 1));
  const Vec3 up(0, 1, 0);
  const DiscPairs before{{0, 1}, {0, 1}, up}, next{{1, 1.5}, {0, 1}, up};
  const DiscPairs last{{1.5, 2}, {0, 1}, {}}, all{{1, 2}, {0, 1}, {}};
  EXPECT_TRUE(follows(corner(), on, {kEndToStart}, clearance(0, {before, next, last})));
  EXPECT_FALSE(follows(corner(), on, {kEndToStart}, clearance(0, {before, all})));
  EXPECT_FALSE(follows(corner(), on, {kEndToStart}, clearance(0, {before, last})));
  EXPECT_FALSE(follows(corner(), on, {kEndToStart}, clearance(0, {next, last})));
  const auto turned = [](const DiscPairs& pair) {
    DiscPairs result{pair.second, pair.first, pair.direction};
    if (pair.direction) {
      result.direction = -*pair.direction;
    }
    return result;
  };
  EXPECT_TRUE(follows(on, corner(), {kStartToEnd},
                      clearance(0, {turned(before), turned(next), turned(last)})));
  EXPECT_FALSE(follows(on, corner(), {kStartToEnd}, clearance(0, {turned(before), turned(all)})));
}

TEST(PairClaimsOfKneecaps, are_embedded_piece_by_piece) {
  const DiscPairs first{{0, 1}, {0, 1}, {}}, second{{1, 2}, {1, 2}, {}};
  EXPECT_TRUE(follows(corner(), embedded({first, second}), kRegular));
  EXPECT_FALSE(follows(corner(), embedded({first}), kRegular));
  EXPECT_FALSE(follows(corner(), embedded({second}), kRegular));
  EXPECT_FALSE(follows(corner(), embedded({first, second, {{.5, 1}, {1, 1.5}, {}}}), kRegular))
      << "a way through the joint";
  EXPECT_FALSE(follows(corner(), embedded({{{0, 2}, {0, 2}, {}}}), kRegular));
}

TEST(PairClaimsOfKneecaps, are_embedded_within_a_piece_whatever_its_balls_reach) {
  const DiscPairs first{{0, 1}, {0, 1}, {}}, second{{1, 2}, {1, 2}, {}};
  // A plane across the axis, behind which the joint's ball reaches.
  const DiscPairs within{{.75, .875}, {.9375, 1}, Vec3(1, 0, 0)};
  EXPECT_TRUE(follows(corner(), embedded({first, second, within}), kRegular));
  const DiscPairs back{{.75, .875}, {.9375, 1}, Vec3(-1, 0, 0)};
  EXPECT_FALSE(follows(corner(), embedded({first, second, back}), kRegular));
}

// Three pieces: the first and the last one are no neighbours, and their joints' balls are apart.
std::vector<PeVector> bow(double end) {
  return {test::sphere(-4, 0, 0, 1), test::sphere(-2, 0, 0, 1), test::sphere(0, 0, 0, 1),
          test::sphere(0, 3, 0, 1),  test::sphere(0, 6, 0, 1),  test::sphere(end / 2, 6, 0, 1),
          test::sphere(end, 6, 0, 1)};
}

TEST(PairClaimsOfKneecaps, are_embedded_where_others_than_neighbours_are_apart) {
  const std::vector<DiscPairs> own{
      {{0, 1}, {0, 1}, {}}, {{1, 2}, {1, 2}, {}}, {{2, 3}, {2, 3}, {}}};
  const auto with = [&](const std::optional<Vec3>& direction) {
    std::vector<DiscPairs> leaves = own;
    leaves.push_back({{0, 1}, {2, 3}, direction});
    return embedded(leaves);
  };
  EXPECT_TRUE(follows(chain(bow(4)), with(Vec3(0, 1, 0)), kRegular));
  EXPECT_TRUE(follows(chain(bow(-4)), with(Vec3(0, 1, 0)), kRegular));
  EXPECT_FALSE(follows(chain(bow(4)), embedded(own), kRegular)) << "nothing is said of them";
  EXPECT_FALSE(follows(chain(bow(4)), with({}), kRegular)) << "a way through two joints";
  EXPECT_FALSE(follows(chain(bow(4)), with(Vec3(1, 0, 0)), kRegular));
}

// The first and the last piece keep 0.1 from each other, the joints' balls, of radius 1, do not.
TEST(PairClaimsOfKneecaps, are_not_embedded_where_balls_of_others_meet) {
  std::vector<PeVector> spheres = bow(4);
  spheres[3].m.y() = .95;
  for (const std::size_t i : {4U, 5U, 6U}) {
    spheres[i].m.y() = 1.9;
  }
  const std::vector<DiscPairs> leaves{{{0, 1}, {0, 1}, {}},
                                      {{1, 2}, {1, 2}, {}},
                                      {{2, 3}, {2, 3}, {}},
                                      {{0, 1}, {2, 3}, Vec3(1, 0, 0)}};
  EXPECT_FALSE(follows(chain(spheres), embedded(leaves), kRegular));
}

// They hold more than their discs, of which a point of two parts may be one.
TEST(PairClaimsOfKneecaps, have_no_point_in_common_with_others) {
  const Solid across = test::solid(test::cylinder({-2, -3, 0}, {-2, 3, 0}, .5));
  const ClearanceClaim meets{0, 1,  Verdict::proved,
                             0, {}, Overlap{Vec3(-2, 0, 0), {.4375, .5625}, {.4375, .5625}}};
  EXPECT_FALSE(follows(corner(), across, {}, meets));
  const Solid pipe = test::solid(test::cylinder({-4, 0, 0}, {0, 0, 0}, 1));
  EXPECT_TRUE(follows(pipe, across, {}, meets));
}

}  // namespace
}  // namespace dupin::verification
