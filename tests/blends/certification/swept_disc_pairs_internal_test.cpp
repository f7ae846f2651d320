#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "blends/certification/disc_samples.h"
#include "certification/swept_disc_pairs.h"
#include "dupin/blends/cyclide_tube.h"
#include "support/cyclide_cases.h"

namespace dupin::certification {
namespace {

using test::cylinder;
using test::disc_at;
using test::elbow;
using test::is_inside;

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kBoxes = 1 << 14;

// Some parameters of a stretch, its ends included.
std::vector<double> within(const ParameterInterval& t, int steps) {
  std::vector<double> result;
  for (int i = 0; i <= steps; ++i) {
    result.push_back(std::lerp(t.from, t.to, double(i) / steps));
  }
  return result;
}

// Points of the first one's discs lie behind those of the second one's by as much.
void expect_apart(const Chain& first, const Chain& second, const DiscPairs& leaf, double distance) {
  const Vec3 direction = leaf.direction->normalized();
  double behind = -1e300, front = 1e300;
  for (const double s : within(leaf.first, 4)) {
    for (const Vec3& point : disc_at(first, s).points()) {
      behind = std::max(behind, point.dot(direction));
    }
  }
  for (const double t : within(leaf.second, 4)) {
    for (const Vec3& point : disc_at(second, t).points()) {
      front = std::min(front, point.dot(direction));
    }
  }
  EXPECT_GE(front - behind, distance);
}

bool covers(const std::vector<DiscPairs>& leaves, double s, double t) {
  return std::any_of(leaves.begin(), leaves.end(), [&](const DiscPairs& leaf) {
    return leaf.first.from <= s && s <= leaf.first.to && leaf.second.from <= t &&
           t <= leaf.second.to;
  });
}

TEST(SweptDiscPairs, hulls_are_separated_by_a_slab) {
  const SweptDiscs pipe(cylinder(Vec3(-5, 0, 0), Vec3(5, 0, 0), 1));
  const auto apart = [&](const SweptDiscs& other) {
    return separation(pipe.over({0, 1}), other.over({0, 1}));
  };
  const struct {
    SweptDiscs other;
    double exact;
    Vec3 direction;
  } rows[] = {
      {SweptDiscs(cylinder(Vec3(-5, 0, 4), Vec3(5, 0, 4), 2)), 1, Vec3(0, 0, 1)},
      {SweptDiscs(cylinder(Vec3(0, -5, 4), Vec3(0, 5, 4), 2)), 1, Vec3(0, 0, 1)},
      {SweptDiscs(cylinder(Vec3(7, 0, 0), Vec3(9, 0, 0), 3)), 2, Vec3(1, 0, 0)},
      {SweptDiscs(Sphere{Vec3(1, 0, -8), 4}), 3, Vec3(0, 0, -1)},
  };
  for (const auto& row : rows) {
    const Separation found = apart(row.other);
    EXPECT_LE(found.distance, row.exact);
    EXPECT_GT(found.distance, 0.95 * row.exact);
    EXPECT_GE(found.nearest, 0.95 * row.exact);
    EXPECT_GT(found.direction.normalized().dot(row.direction), 0.95);
  }
  EXPECT_LE(apart(SweptDiscs(cylinder(Vec3(0, -5, 1), Vec3(0, 5, 1), 1))).distance, 0);
  EXPECT_LE(apart(SweptDiscs(cylinder(Vec3(5, 0, 0), Vec3(9, 0, 0), 1))).distance, 0) << "touching";
}

TEST(SweptDiscPairs, clearances_are_nearly_the_distance) {
  const struct {
    Chain first, second;
    double exact;
  } rows[] = {
      {cylinder(Vec3(-5, 0, 0), Vec3(5, 0, 0), 1), cylinder(Vec3(1, -5, 3), Vec3(1, 5, 3), 1), 1},
      // The ring around the z axis, and a pipe along that.
      {elbow(3, 2, 0.5), cylinder(Vec3(0, 0, -4), Vec3(0, 0, 4), 0.5), 2},
      // A straight piece after a bend, and its neighbour.
      {Chain(std::vector{elbow(3, kPi / 2, 1), cylinder(Vec3(0, 3, 0), Vec3(-9, 3, 0), 1)}),
       cylinder(Vec3(-5, -3, 0), Vec3(-5, 1.75, 0), 0.5), 0.25},
  };
  for (const auto& row : rows) {
    const ClearanceClaim claim =
        prove_clearance(SweptDiscs(row.first), SweptDiscs(row.second), kBoxes);
    EXPECT_EQ(claim.verdict, Verdict::proved);
    EXPECT_FALSE(claim.overlap);
    EXPECT_LE(claim.distance, row.exact);
    EXPECT_GE(claim.distance, 0.89 * row.exact);
    const auto length = [](const Chain& chain) { return double(chain.pieces.size()); };
    for (const double s : within({0, length(row.first)}, 37)) {
      for (const double t : within({0, length(row.second)}, 37)) {
        EXPECT_TRUE(covers(claim.leaves, s, t)) << s << " " << t;
      }
    }
    for (const DiscPairs& leaf : claim.leaves) {
      ASSERT_TRUE(leaf.direction);
      expect_apart(row.first, row.second, leaf, claim.distance);
    }
  }
}

TEST(SweptDiscPairs, clearances_of_what_overlaps_are_a_point_of_both) {
  const Chain pipe = cylinder(Vec3(-5, 0, 0), Vec3(5, 0, 0), 1),
              other = cylinder(Vec3(1, -5, 1), Vec3(1, 5, 1), 0.75);
  const ClearanceClaim claim = prove_clearance(SweptDiscs(pipe), SweptDiscs(other), kBoxes);
  EXPECT_EQ(claim.verdict, Verdict::proved);
  EXPECT_EQ(claim.distance, 0);
  ASSERT_TRUE(claim.overlap);
  EXPECT_TRUE(is_inside(pipe, claim.overlap->first, claim.overlap->point));
  EXPECT_TRUE(is_inside(other, claim.overlap->second, claim.overlap->point));
  EXPECT_EQ(prove_clearance(SweptDiscs(pipe), SweptDiscs(other), 0).verdict, Verdict::proved)
      << "a common point is looked for whatever work is left";
}

// Every pair of discs is covered, and those with a plane between them are on its two sides.
void expect_embedded(const Chain& chain) {
  const EmbeddedClaim claim = prove_embedded(SweptDiscs(chain), 0.25, kBoxes);
  ASSERT_EQ(claim.verdict, Verdict::proved);
  EXPECT_FALSE(claim.overlap);
  const auto length = double(chain.pieces.size());
  for (const double s : within({0, length}, 53)) {
    for (const double t : within({s, length}, 53)) {
      EXPECT_TRUE(covers(claim.leaves, s, t)) << s << " " << t;
    }
  }
  for (const DiscPairs& leaf : claim.leaves) {
    if (leaf.direction) {
      expect_apart(chain, chain, leaf, 0);
    }
  }
}

// Each pair of many that pass a place has its claim: none may use up what all have.
TEST(SweptDiscPairs, that_pipes_cross_is_told_by_few_discs) {
  std::mt19937 random(20);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> share(-0.99, 0.99);
  constexpr std::uint64_t kEnough = 200;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const auto direction = [&] {
      return Vec3(normal(random), normal(random), normal(random)).normalized();
    };
    const Vec3 along = direction(), across = direction();
    const Vec3 apart = 5 * share(random) * along.cross(across).normalized();
    const Chain one = test::cylinder(-100 * along, 100 * along, 3);
    const Chain other = test::cylinder(apart - 70 * across, apart + 90 * across, 2);
    SearchWork work(kEnough);
    const ClearanceClaim claim =
        prove_clearance(SweptDiscs(one, &work), SweptDiscs(other, &work), 1 << 10);
    ASSERT_TRUE(claim.overlap);
    EXPECT_TRUE(test::is_inside(one, claim.overlap->first, claim.overlap->point));
    EXPECT_TRUE(test::is_inside(other, claim.overlap->second, claim.overlap->point));
    EXPECT_GT(work.left(), 0U);
  }
}

TEST(SweptDiscPairs, parts_that_come_back_beside_themselves_are_embedded) {
  expect_embedded(cylinder(Vec3::Zero(), Vec3(5, 0, 0), 1));
  expect_embedded(elbow(3, 5.5, 1));
  expect_embedded(test::loop(1.5));
  expect_embedded(
      Chain(std::vector{elbow(3, kPi, 1),
                        [] {
                          RingedSurface half = elbow(3, kPi, 1);
                          std::swap(half.start, half.end);
                          half.start = flipped(half.start);
                          half.end = flipped(half.end);
                          half.spine = ArcSpine{Vec3::Zero(), Vec3::UnitZ(), Vec3(-3, 0, 0), kPi};
                          return half;
                        }()},
            true));
}

// Straight pieces one after the other.
Chain long_chain(int pieces, double height) {
  std::vector<RingedSurface> all;
  for (double i = 0; i < pieces; ++i) {
    all.push_back(cylinder(Vec3(i, 0, height), Vec3(i + 1, 0, height), 0.25));
  }
  return Chain(all);
}

// Of many pieces, not all pairs are looked at.
TEST(SweptDiscPairs, of_many_pieces_take_as_many_leaves) {
  for (const int pieces : {64, 700}) {
    const Chain low = long_chain(pieces, 0), high = long_chain(pieces, 2);
    const EmbeddedClaim embedded = prove_embedded(SweptDiscs(low), 0.5, kBoxes);
    EXPECT_EQ(embedded.verdict, Verdict::proved);
    EXPECT_LT(embedded.leaves.size(), std::size_t(6 * pieces));
    const ClearanceClaim claim = prove_clearance(SweptDiscs(low), SweptDiscs(high), kBoxes);
    EXPECT_EQ(claim.verdict, Verdict::proved);
    EXPECT_GT(claim.distance, 1.3);
    EXPECT_LE(claim.distance, 1.5);
    EXPECT_LT(claim.leaves.size(), std::size_t(20 * pieces));
    for (const DiscPairs& leaf : claim.leaves) {
      expect_apart(low, high, leaf, claim.distance);
    }
  }
  const auto [left, right] = halves({3, 8});
  EXPECT_EQ(left, (ParameterInterval{3, 5}));
  EXPECT_EQ(right, (ParameterInterval{5, 8}));
}

TEST(SweptDiscPairs, parts_that_cross_themselves_are_not_embedded) {
  const Chain crossing = test::loop(6);
  const EmbeddedClaim claim = prove_embedded(SweptDiscs(crossing), 0.25, 1 << 9);
  EXPECT_EQ(claim.verdict, Verdict::refuted);
  EXPECT_TRUE(claim.leaves.empty());
  ASSERT_TRUE(claim.overlap);
  EXPECT_TRUE(is_inside(crossing, claim.overlap->first, claim.overlap->point));
  EXPECT_TRUE(is_inside(crossing, claim.overlap->second, claim.overlap->point));
  // Discs that overlap do not tell of a part that is not all of them.
  Chain hollow = crossing;
  hollow.wall = 0.25;
  const EmbeddedClaim unknown = prove_embedded(SweptDiscs(hollow), 0.25, 1 << 9);
  EXPECT_EQ(unknown.verdict, Verdict::undecided);
  EXPECT_FALSE(unknown.overlap);
}

TEST(SweptDiscPairs, no_more_work_is_done_than_allowed) {
  Chain hollow = test::elbow_of_bezier(3, 3, 1);
  hollow.wall = 0.25;
  EXPECT_EQ(prove_embedded(SweptDiscs(hollow), 0.25, kBoxes).verdict, Verdict::proved);
  EXPECT_EQ(prove_embedded(SweptDiscs(hollow), 0.25, 1).verdict, Verdict::undecided);
}

// What all claims may take together: found in the first look, or undecided.
TEST(SweptDiscPairs, searches_end_when_the_work_of_all_is_used_up) {
  SearchWork enough(1 << 16), none(0);
  const Chain pipe = cylinder(Vec3(-5, 0, 0), Vec3(5, 0, 0), 1),
              across = cylinder(Vec3(1, -5, 1), Vec3(1, 5, 1), 0.75), bend = elbow(3, 5.5, 1),
              turned = test::elbow_of_bezier(3, 3, 1);
  const Sphere inside{Vec3::Zero(), 1};  // of the bend, whose hull holds it
  for (SearchWork* work : {&enough, &none}) {
    const bool found = work == &enough;
    const auto verdict_if_found = found ? Verdict::proved : Verdict::undecided;
    EXPECT_EQ(prove_clearance(SweptDiscs(bend, work), SweptDiscs(inside, work), kBoxes).verdict,
              verdict_if_found);
    EXPECT_EQ(prove_clearance(SweptDiscs(pipe, work), SweptDiscs(across, work), kBoxes).verdict,
              verdict_if_found);
    EXPECT_EQ(prove_embedded(SweptDiscs(turned, work), 0.25, kBoxes).verdict, verdict_if_found);
    const SweptDiscs straight(pipe, work);
    EXPECT_EQ(prove_embedded(straight, 0.25, kBoxes).verdict, Verdict::proved);
    const ClearanceClaim clear =
        prove_clearance(straight, SweptDiscs(Sphere{Vec3(0, 0, 8), 1}, work), kBoxes);
    EXPECT_EQ(clear.verdict, Verdict::proved);
    EXPECT_GT(clear.distance, 5);
    EXPECT_EQ(work->is_used_up(), !found);
  }
}

// A pipe that ends where the bend begins, which comes back to it if it turns far enough.
ClearanceClaim joint(double angle) {
  const SweptDiscs pipe(cylinder(Vec3(3, -9, 0), Vec3(3, 0, 0), 1)), bend(elbow(3, angle, 1));
  return prove_joint(pipe, bend, {{End::end, End::start}}, 1 << 10);
}

TEST(SweptDiscPairs, joined_parts_have_nothing_but_the_joint_in_common) {
  const Chain pipe = cylinder(Vec3(3, -9, 0), Vec3(3, 0, 0), 1), bend = elbow(3, 4, 1);
  const ClearanceClaim claim = joint(4);
  ASSERT_EQ(claim.verdict, Verdict::proved);
  EXPECT_EQ(claim.distance, 0);
  EXPECT_FALSE(claim.overlap);
  for (const double s : within({0, 1}, 53)) {
    for (const double t : within({0, 1}, 53)) {
      EXPECT_TRUE(covers(claim.leaves, s, t)) << s << " " << t;
    }
  }
  for (const DiscPairs& leaf : claim.leaves) {
    if (leaf.direction) {
      expect_apart(pipe, bend, leaf, 0);
    } else {
      EXPECT_LT(4 * leaf.second.to, kPi) << "no way back";
    }
  }
  EXPECT_TRUE(covers(claim.leaves, 1, 0));
}

// Of a bend of hardly more than the pipe's radius planes would tell apart what is near each other
// in thousands of leaves.
TEST(SweptDiscPairs, tight_bends_are_told_apart_by_where_they_are) {
  for (const double bend : {1.0001, 1.01, 1.5}) {
    const Chain pipe = cylinder(Vec3(bend, -9, 0), Vec3(bend, 0, 0), 1);
    EXPECT_EQ(prove_embedded(SweptDiscs(elbow(bend, 6.28, 1)), 0x1p-60, 1).leaves.size(), 1);
    for (const double angle : {kPi / 2, 3.1, kPi}) {
      const ClearanceClaim claim = prove_joint(SweptDiscs(pipe), SweptDiscs(elbow(bend, angle, 1)),
                                               {{End::end, End::start}}, 100);
      EXPECT_EQ(claim.verdict, Verdict::proved) << bend << " " << angle;
    }
  }
}

// A loop of two half turns: the way from the one to the other is short at both ends.
TEST(SweptDiscPairs, half_turns_of_a_closed_part_are_apart) {
  RingedSurface there = elbow(3, kPi, 2.99), back = there;
  std::get<ArcSpine>(back.spine).start = -std::get<ArcSpine>(there.spine).start;
  Chain loop(std::vector{there, back});
  loop.closed = true;
  EXPECT_EQ(prove_embedded(SweptDiscs(loop), 0x1p-60, 1000).verdict, Verdict::proved);
}

TEST(SweptDiscPairs, joined_parts_may_meet_again) {
  const ClearanceClaim claim = joint(5.5);
  EXPECT_EQ(claim.verdict, Verdict::refuted);
  ASSERT_TRUE(claim.overlap);
  EXPECT_TRUE(is_inside(elbow(3, 5.5, 1), claim.overlap->second, claim.overlap->point));
  EXPECT_LT(std::hypot(claim.overlap->point.x() - 3, claim.overlap->point.z()), 1);
  EXPECT_LT(claim.overlap->point.y(), 0);
}

// Pipes of radius 1 along the x axis to the origin and from there along the y axis, with a sector
// of a ball between them.
Chain knee() { return kneecap_chain(test::corner_spheres(kPi / 2)); }

TEST(SweptDiscPairs, pieces_with_a_kneecap_are_embedded_each_by_itself) {
  const EmbeddedClaim claim = prove_embedded(SweptDiscs(knee()), 0.25, kBoxes);
  ASSERT_EQ(claim.verdict, Verdict::proved);
  EXPECT_TRUE(covers(claim.leaves, .25, .75));
  EXPECT_TRUE(covers(claim.leaves, 1.25, 1.75));
  EXPECT_FALSE(covers(claim.leaves, .25, 1.75)) << "neighbours";
}

TEST(SweptDiscPairs, pieces_that_are_no_neighbours_are_apart_with_their_kneecaps) {
  const auto bow = [](double back) {
    return kneecap_chain(std::vector<PeVector>{
        test::sphere(-4, 0, 0, 1), test::sphere(-2, 0, 0, 1), test::sphere(0, 0, 0, 1),
        test::sphere(0, 2, 0, 1), test::sphere(0, 4, 0, 1), test::sphere(-2, 4 - back / 2, 0, 1),
        test::sphere(-4, 4 - back, 0, 1)});
  };
  const EmbeddedClaim claim = prove_embedded(SweptDiscs(bow(0)), 0.25, kBoxes);
  ASSERT_EQ(claim.verdict, Verdict::proved);
  EXPECT_TRUE(covers(claim.leaves, .25, 2.75));
  const EmbeddedClaim meets = prove_embedded(SweptDiscs(bow(4)), 0.25, 1 << 9);
  EXPECT_EQ(meets.verdict, Verdict::undecided);
  EXPECT_TRUE(meets.leaves.empty());
}

TEST(SweptDiscPairs, parts_keep_their_distance_from_kneecaps) {
  const Vec3 out = Vec3(1, -1, 0).normalized();
  const ClearanceClaim claim =
      prove_clearance(SweptDiscs(knee()), SweptDiscs(Sphere{1.5 * out, .25}), kBoxes);
  ASSERT_EQ(claim.verdict, Verdict::proved);
  EXPECT_LE(claim.distance, .25);
  EXPECT_GE(claim.distance, .2);
  EXPECT_EQ(prove_clearance(SweptDiscs(knee()), SweptDiscs(Sphere{out, .05}), 1 << 9).verdict,
            Verdict::undecided);
}

TEST(SweptDiscPairs, joined_parts_have_nothing_in_common_with_kneecaps) {
  const Chain on = cylinder(Vec3(0, 4, 0), Vec3(0, 9, 0), 1);
  const ClearanceClaim claim =
      prove_joint(SweptDiscs(knee()), SweptDiscs(on), {{End::end, End::start}}, kBoxes);
  ASSERT_EQ(claim.verdict, Verdict::proved);
  for (const DiscPairs& leaf : claim.leaves) {
    EXPECT_TRUE(leaf.direction || leaf.first.from > 1);
  }
}

}  // namespace
}  // namespace dupin::certification
