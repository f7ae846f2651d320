#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "certification/prove_fillet.h"
#include "certification/prove_loop_clearance.h"
#include "support/fillet_loops.h"
#include "verification/loop_clearance.h"

namespace dupin::verification {
namespace {

CertifiedPart part(const PartSurface& shape) { return {"part", "part", shape, {}}; }

CertifiedPart ball_part(const Vec3& center, double radius) { return part(Sphere{center, radius}); }

CertifiedPart pipe_part(const Vec3& from, const Vec3& to, double radius) {
  const Vec3 along = (to - from).normalized();
  return part(Chain(RingedSurface{
      {from, -along, radius}, {to, along, radius}, LineSpine{from, to}, ConstantRadius{radius}}));
}

LoopArcs arcs_of(const CanalFillet& loop) {
  const double margin = 0.5 * dupin::prove_regular(loop).regularity;
  LoopArcs arcs{&loop, {}};
  for (int i = 0; i < 256; ++i) {
    const auto cell = regular_cell(loop, {i / 128.0, (i + 1) / 128.0}, margin);
    EXPECT_TRUE(cell);
    arcs.cells.push_back(*cell);
  }
  return arcs;
}

// As the prover finds it.
ClearanceClaim claim_of(const CertifiedPart& other, const LoopArcs& arcs) {
  const certification::SweptDiscs sweep =
      std::visit([](const auto& s) { return certification::SweptDiscs(s); }, other.shape);
  return certification::prove_clearance(sweep, arcs, certification::swept_arcs(arcs), 1 << 14);
}

ClearanceClaim claim_of(const LoopArcs& first, const LoopArcs& second) {
  return certification::prove_clearance(first, certification::swept_arcs(first), second,
                                        certification::swept_arcs(second), 1 << 14);
}

TEST(LoopClearance, follows_up_to_the_distance_that_there_is) {
  int undecided = 0;
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    const LoopArcs arcs = arcs_of(loop);
    const ContactArc arc = contact_arc(loop.quadrics, ball(loop, 0.4));
    const Vec3 place = point(arc, arc.angle / 2), out = ball(loop, 0.4).center - place;
    // Beyond the ball that rolls: what is nearer lies in hulls of arcs.
    const double size = 0.25 * out.norm(), there_is = 2 * out.norm() - size;
    const CertifiedPart small = ball_part(place + 2 * out, size);
    const Solid other(small);
    const ClearanceClaim claim = claim_of(small, arcs);
    if (claim.verdict == Verdict::undecided) {
      ++undecided;  // in the hull of some arc
      continue;
    }
    EXPECT_FALSE(claim.overlap) << name;
    EXPECT_GT(claim.distance, 0) << name;
    EXPECT_LE(claim.distance, there_is * (1 + 1e-9)) << name;
    EXPECT_TRUE(follows(other, arcs, claim)) << name;
    ClearanceClaim more = claim;
    more.distance = 1.01 * there_is;
    EXPECT_FALSE(follows(other, arcs, more)) << name;
  }
  EXPECT_LE(undecided, 2);
}

TEST(LoopClearance, does_not_follow_when_changed) {
  const CanalFillet loop = test::loops_of_all_kinds().front().loop;
  const LoopArcs arcs = arcs_of(loop);
  const CertifiedPart certified = pipe_part({20, -5, 0}, {20, 5, 0}, 1);
  const Solid other(certified);
  const ClearanceClaim honest = claim_of(certified, arcs);
  ASSERT_TRUE(follows(other, arcs, honest));
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<const char*, std::function<void(ClearanceClaim&)>>> changes{
      {"a leaf less", [](auto& c) { c.leaves.pop_back(); }},
      {"no leaves", [](auto& c) { c.leaves.clear(); }},
      {"a leaf of nothing",
       [](auto& c) { c.leaves.front().second.to = c.leaves.front().second.from; }},
      {"a leaf beyond its end", [](auto& c) { c.leaves.back().second.to = 2.5; }},
      {"a direction turned round",
       [](auto& c) { c.leaves.front().direction = -*c.leaves.front().direction; }},
      {"no direction", [](auto& c) { c.leaves.front().direction.reset(); }},
      {"a direction of no length", [](auto& c) { c.leaves.front().direction = Vec3(0, 0, 0); }},
      {"a direction of no number", [&](auto& c) { c.leaves.front().direction = Vec3(kNaN, 0, 0); }},
      {"no distance", [](auto& c) { c.distance = 0; }},
      {"a negative distance", [](auto& c) { c.distance = -1; }},
      {"no number", [&](auto& c) { c.distance = kNaN; }},
      {"refuted", [](auto& c) { c.verdict = Verdict::refuted; }},
      {"a point besides", [](auto& c) {
         c.overlap = Overlap{{20, 0, 0}, {0.25, 0.75}, {1, 1}};
       }}};
  for (const auto& [what, change] : changes) {
    ClearanceClaim claim = honest;
    change(claim);
    EXPECT_FALSE(follows(other, arcs, claim)) << what;
  }
  EXPECT_FALSE(follows(other, LoopArcs{&loop, {}}, honest)) << "of arcs that nothing is known of";
}

TEST(LoopClearance, of_what_overlaps_is_a_point_of_both) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    const LoopArcs arcs = arcs_of(loop);
    const ContactArc arc = contact_arc(loop.quadrics, ball(loop, 2.5));
    const Vec3 place = point(arc, arc.angle / 2);
    for (const CertifiedPart& certified :
         {ball_part(place, 0.3), pipe_part(place - Vec3(1, 1, 1), place + Vec3(1, 1, 1), 0.3)}) {
      const Solid other(certified);
      const ClearanceClaim claim = claim_of(certified, arcs);
      ASSERT_EQ(claim.verdict, Verdict::proved) << name;
      ASSERT_TRUE(claim.overlap) << name;
      EXPECT_TRUE(follows(other, arcs, claim)) << name;
      for (const auto& change : std::vector<std::function<void(ClearanceClaim&)>>{
               [](auto& c) { c.overlap->point += Vec3(9, 0, 0); },
               [](auto& c) { c.overlap->second.to += 0.25; },
               [](auto& c) {
                 c.overlap->second = {3, 3};
               },
               [](auto& c) { c.distance = 1e-3; },
               [](auto& c) {
                 c.overlap->second = {std::fmod(c.overlap->second.from + 1, 2),
                                      std::fmod(c.overlap->second.from + 1, 2)};
               },
               [](auto& c) { c.verdict = Verdict::refuted; }}) {
        ClearanceClaim lie = claim;
        change(lie);
        EXPECT_FALSE(follows(other, arcs, lie)) << name;
      }
    }
  }
}

// Both loops of a pipe that passes are apart; of equal and touching ones they meet in corners.
TEST(LoopClearance, of_the_loops_of_a_fillet_is_a_distance_or_their_corners) {
  std::vector<test::NamedLoop> loops = test::loops_of_all_kinds();
  int meet = 0;
  for (std::size_t i = 0; i + 1 < loops.size(); ++i) {
    const auto& [name, first] = loops[i];
    const auto& [other, second] = loops[i + 1];
    if (name.back() != '0' || other.back() != '1') {
      continue;
    }
    const LoopArcs a = arcs_of(first), b = arcs_of(second);
    const ClearanceClaim claim = claim_of(a, b);
    ASSERT_EQ(claim.verdict, Verdict::proved) << name;
    EXPECT_TRUE(follows(a, b, claim)) << name;
    EXPECT_EQ(share_corners(first, second), claim.distance == 0) << name;
    meet += claim.distance == 0 ? 1 : 0;
    ClearanceClaim lie = claim;
    lie.distance = claim.distance == 0 ? 1e-9 : 0;
    EXPECT_FALSE(follows(a, b, lie)) << name;
    lie = claim;
    lie.leaves.erase(lie.leaves.begin() + std::ptrdiff_t(lie.leaves.size() / 2));
    EXPECT_FALSE(follows(a, b, lie)) << name;
    if (claim.distance == 0) {
      lie = claim;
      for (DiscPairs& leaf : lie.leaves) {
        leaf.direction = -*leaf.direction;
      }
      EXPECT_FALSE(follows(a, b, lie)) << name;
      EXPECT_FALSE(follows(a, a, claim)) << name << ": a loop and itself";
    }
  }
  EXPECT_EQ(meet, 2);
}

}  // namespace
}  // namespace dupin::verification
