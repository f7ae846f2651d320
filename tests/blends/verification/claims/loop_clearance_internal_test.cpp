#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "certification/prove_fillet.h"
#include "certification/prove_loop_clearance.h"
#include "support/fillet_loops.h"
#include "verification/claims/loop_clearance.h"

namespace dupin::verification {
namespace {

CertifiedPart part(const PartSurface& shape) { return {"part", "part", shape, {}}; }

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMostAtCorner = 0x1p-30;

CertifiedPart ball_part(const Vec3& center, double radius) { return part(Sphere{center, radius}); }

CertifiedPart pipe_part(const Vec3& from, const Vec3& to, double radius) {
  const Vec3 along = (to - from).normalized();
  return part(Chain(RingedSurface{
      {from, -along, radius}, {to, along, radius}, LineSpine{from, to}, ConstantRadius{radius}}));
}

LoopArcs arcs_of(const CanalFillet& loop, int cells = 256) {
  const double margin = 0.5 * dupin::prove_regular(loop).regularity;
  LoopArcs arcs{&loop, {}};
  for (double i = 0; i < cells; ++i) {
    const auto cell = regular_cell(loop, {2 * i / cells, 2 * (i + 1) / cells}, margin);
    EXPECT_TRUE(cell);
    arcs.cells.push_back(*cell);
  }
  return arcs;
}

// As the prover finds it.
ClearanceClaim claim_of(const CertifiedPart& other, const LoopArcs& arcs) {
  const certification::SweptDiscs sweep =
      std::visit([](const auto& s) { return certification::SweptDiscs(s); }, other.shape);
  const certification::SweptDiscs loop = certification::swept_arcs(arcs);
  return certification::prove_clearance(certification::SweptPart{Solid(other), sweep}, {arcs, loop},
                                        {1 << 14, kMostAtCorner});
}

ClearanceClaim claim_of(const LoopArcs& first, const LoopArcs& second) {
  const certification::SweptDiscs one = certification::swept_arcs(first),
                                  other = certification::swept_arcs(second);
  return certification::prove_clearance(certification::SweptLoop{first, one}, {second, other},
                                        {1 << 14, kMostAtCorner});
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

const CanalFillet& loop_of(const std::string& name) {
  static const auto loops = test::loops_of_all_kinds();
  return std::ranges::find(loops, name, &test::NamedLoop::name)->loop;
}

// Arcs at one place that move along the x axis.
LoopArcs hand_made(const CanalFillet& loop, const Vec3& place) {
  LoopArcs arcs{&loop, {}};
  for (int i = 0; i < 8; ++i) {
    ArcCell& cell = arcs.cells.emplace_back(ArcCell{{i / 4., (i + 1) / 4.}, {}});
    cell.arcs.tangent = numbers::interval_vec(Vec3::UnitX());
    cell.arcs.passing = 1;
    cell.arcs.corners.fill(numbers::interval_vec(place));
  }
  return arcs;
}

ClearanceClaim apart(double distance, const std::vector<DiscPairs>& leaves) {
  return {0, 1, Verdict::proved, distance, leaves, {}};
}

// For all of a part of length 1, or half of a loop, and a loop.
std::vector<DiscPairs> all_leaves(const Vec3& direction) {
  return {{{0, 1}, {0, 1}, direction}, {{0, 1}, {1, 2}, direction}};
}

TEST(LoopClearance, corners_are_shared_by_loops_that_differ_in_their_side_only) {
  for (const char* name : {"equal", "touching"}) {
    const CanalFillet &first = loop_of(std::string(name) + "_0"),
                      &second = loop_of(std::string(name) + "_1");
    EXPECT_TRUE(share_corners(first, second)) << name;
    using Through = RollingThrough;
    const std::vector<std::function<void(Through&)>> changes{
        [](Through& m) { m.origin.x() += 1; },    [](Through& m) { m.along = -m.along; },
        [](Through& m) { m.across = -m.across; }, [](Through& m) { m.up = -m.up; },
        [](Through& m) { m.cosine = -.25; },      [](Through& m) { m.sine /= 2; },
        [](Through& m) { m.distance += 1; },      [](Through& m) { m.height += .25; },
        [](Through& m) { m.below += .25; },       [](Through& m) { m.above += .25; },
        [](Through& m) { m.radius += .25; }};
    for (std::size_t i = 0; i < changes.size(); ++i) {
      CanalFillet other = second;
      changes[i](std::get<RollingThrough>(other.motion));
      EXPECT_FALSE(share_corners(first, other)) << name << " " << i;
    }
    EXPECT_FALSE(share_corners(first, loop_of("partly_0")));
    EXPECT_FALSE(share_corners(loop_of("partly_0"), first));
  }
  EXPECT_FALSE(share_corners(loop_of("through_0"), loop_of("through_1"))) << "they have none";
}

TEST(LoopClearance, at_corners_is_of_arcs_that_move_to_both_sides) {
  const CanalFillet& loop = loop_of("equal_0");
  const LoopArcs on = hand_made(loop, {0, 0, 0});
  LoopArcs back = on;
  for (ArcCell& cell : back.cells) {
    cell.arcs.passing = -1;
  }
  const Vec3 x = Vec3::UnitX();
  const ParameterInterval before{.75, 1}, after{1, 1.25}, first{0, .25}, last{1.75, 2};
  EXPECT_EQ(gap_at_corner(on, on, {before, after, x}), 0);
  EXPECT_EQ(gap_at_corner(on, on, {before, after, -x}), kInfinity);
  EXPECT_EQ(gap_at_corner(on, on, {after, before, -x}), 0);
  EXPECT_EQ(gap_at_corner(on, on, {last, first, x}), 0);
  EXPECT_EQ(gap_at_corner(on, on, {first, last, -x}), 0);
  EXPECT_EQ(gap_at_corner(on, back, {before, before, x}), 0);
  EXPECT_EQ(gap_at_corner(on, on, {before, before, x}), kInfinity);
  EXPECT_EQ(gap_at_corner(back, on, {before, after, x}), kInfinity);
  EXPECT_EQ(gap_at_corner(on, back, {before, after, x}), kInfinity);
  EXPECT_EQ(gap_at_corner(on, on, {before, after, {}}), kInfinity);
  EXPECT_EQ(gap_at_corner(on, on, {before, first, x}), kInfinity) << "of two corners";
  EXPECT_EQ(gap_at_corner(on, on, {{.5, .75}, after, x}), kInfinity);
  EXPECT_EQ(gap_at_corner(on, on, {before, {1.25, 1.5}, x}), kInfinity);
  const LoopArcs smooth = hand_made(loop_of("through_0"), {0, 0, 0});
  EXPECT_EQ(gap_at_corner(smooth, on, {before, after, x}), kInfinity);
  EXPECT_EQ(gap_at_corner(on, smooth, {before, after, x}), kInfinity);
}

// Of a run and a branch on one side, and of the run and what lies opposite.
std::vector<CanalFillet> opposite_loops(double radius, double other, double lean) {
  const Vec3 at(100.3, -20.1, 7.7), along = Vec3(1, 2, -0.5).normalized();
  const Vec3 across = Vec3(std::cos(lean) * along.unitOrthogonal() + std::sin(lean) * along);
  const Ring run{at + 9 * along, along, 4, 0};
  std::vector<CanalFillet> loops;
  for (const auto& [side, ball] : {std::pair(1.0, radius), {-1.0, other}}) {
    const auto found =
        rolling_ball_fillets({run, Ring{at + side * 12 * across, side * across, 4, 0}}, ball);
    loops.push_back(found.front());
  }
  return loops;
}

TEST(LoopClearance, of_loops_of_two_fillets_may_be_their_corners) {
  for (const double lean : {0., 0.3, -0.6}) {
    const auto loops = opposite_loops(0.5, 0.8, lean);
    const LoopArcs a = arcs_of(loops[0], 1024), b = arcs_of(loops[1], 1024);
    ASSERT_TRUE(has_corner(loops[0], 0) && has_corner(loops[1], 1));
    ASSERT_FALSE(share_corners(loops[0], loops[1]));
    const ClearanceClaim claim = claim_of(a, b);
    ASSERT_EQ(claim.verdict, Verdict::proved) << lean;
    EXPECT_EQ(claim.distance, 0);
    EXPECT_GT(claim.corner, 0);
    EXPECT_LT(claim.corner, 1e-10);
    EXPECT_TRUE(follows(a, b, claim));
    for (const auto& change : std::vector<std::function<void(ClearanceClaim&)>>{
             [](auto& c) { c.corner = 0; }, [](auto& c) { c.corner *= -1; },
             [](auto& c) { c.corner = std::nextafter(c.corner, 0); },
             [](auto& c) { c.corner = std::numeric_limits<double>::quiet_NaN(); },
             [](auto& c) { c.corner = 0x1p301; }, [](auto& c) { c.distance = c.corner; },
             [](auto& c) {
               c.leaves.erase(c.leaves.begin() + std::ptrdiff_t(c.leaves.size() / 2));
             },
             [](auto& c) {
               for (DiscPairs& leaf : c.leaves) {
                 leaf.direction = Vec3(-*leaf.direction);
               }
             }}) {
      ClearanceClaim lie = claim;
      change(lie);
      EXPECT_FALSE(follows(a, b, lie));
    }
    EXPECT_FALSE(follows(a, a, claim)) << "a loop and itself";
    ClearanceClaim wide = claim;
    wide.corner = 0.5;
    EXPECT_TRUE(follows(a, b, wide));
  }
}

// Where the arcs become a point is asked of the loop's own numbers.
TEST(LoopClearance, of_corners_that_are_not_known_nothing_is_told) {
  const CanalFillet& loop = loop_of("equal_0");
  CanalFillet unknown = loop;
  unknown.quadrics[0].normal = Vec3::Zero();
  const ParameterInterval after{1, 1.25};
  ASSERT_TRUE(contact_arcs(loop, {1, 1 + 0x1p-52}));
  ASSERT_FALSE(contact_arcs(unknown, {1, 1 + 0x1p-52}));
  // Not those that both loops have, which are known to be the same.
  CanalFillet other = loop;
  std::get<RollingThrough>(other.motion).radius += 0x1p-30;
  const LoopArcs on = hand_made(other, {0, 0, 0}), lost = hand_made(unknown, {0, 0, 0});
  const Vec3 x = Vec3::UnitX();
  const ParameterInterval before{.75, 1};
  EXPECT_LT(gap_at_corner(on, hand_made(loop, {0, 0, 0}), {before, after, x}), 1);
  EXPECT_EQ(gap_at_corner(on, lost, {before, after, x}), kInfinity);
  EXPECT_EQ(gap_at_corner(lost, on, {before, after, x}), kInfinity);
  const Solid behind(ball_part({-100, 0, 0}, 1));
  EXPECT_EQ(gap_at_corner(behind, hand_made(loop, {0, 0, 0}), {{0, 1}, after, x}), 0);
  EXPECT_EQ(gap_at_corner(behind, lost, {{0, 1}, after, x}), kInfinity);
}

// It is far behind the corner, but that is no distance.
TEST(LoopClearance, of_a_part_with_a_distance_is_no_matter_of_corners) {
  const CanalFillet& loop = loop_of("equal_0");
  const Vec3 center(-100, 0, 0), x = Vec3::UnitX(), y = Vec3::UnitY();
  const Solid behind(ball_part(center, 1));
  const LoopArcs beside = hand_made(loop, center + 4 * y);
  const ParameterInterval all{0, 1}, after{1, 1.25}, rest{1.25, 2};
  ASSERT_EQ(gap_at_corner(behind, beside, {all, after, x}), 0);
  const auto leaves = [&](const Vec3& at_corner) {
    return std::vector<DiscPairs>{{all, {0, 1}, y}, {all, after, at_corner}, {all, rest, y}};
  };
  EXPECT_TRUE(follows(behind, beside, apart(1, leaves(y))));
  EXPECT_FALSE(follows(behind, beside, apart(1, leaves(x))));
}

// It ends in the plane of both corners, with a disc, and is on the other side of it.
TEST(LoopClearance, of_a_part_may_be_the_corners_in_which_it_ends) {
  const CanalFillet loop =
      rolling_ball_fillets({Ring{{0, 0, 0}, {1, 0, 0}, 4, 0}, Ring{{0, 9, 0}, {0, 1, 0}, 4, 0}},
                           0.5)
          .front();
  const LoopArcs arcs = arcs_of(loop);
  const CertifiedPart back = pipe_part({0, 0, 0}, {0, -9, 0}, 4);
  const ClearanceClaim claim = claim_of(back, arcs);
  ASSERT_EQ(claim.verdict, Verdict::proved);
  EXPECT_EQ(claim.distance, 0);
  EXPECT_FALSE(claim.overlap);
  EXPECT_GT(claim.corner, 0);
  EXPECT_LT(claim.corner, 1e-12);
  EXPECT_TRUE(follows(Solid(back), arcs, claim));
  for (const auto& change : std::vector<std::function<void(ClearanceClaim&)>>{
           [](auto& c) { c.corner = 0; }, [](auto& c) { c.corner = std::nextafter(c.corner, 0); },
           [](auto& c) { c.distance = 1e-14; }, [](auto& c) { c.leaves.pop_back(); },
           [](auto& c) { c.leaves.front().direction = Vec3(-*c.leaves.front().direction); }}) {
    ClearanceClaim lie = claim;
    change(lie);
    EXPECT_FALSE(follows(Solid(back), arcs, lie));
  }
  // What reaches across it by more is further from one point, and what lies on this side meets all.
  const Solid further(pipe_part({0, 0.25, 0}, {0, -9, 0}, 4)),
      same(pipe_part({0, 9, 0}, {0, 0, 0}, 4));
  EXPECT_FALSE(follows(further, arcs, claim));
  EXPECT_FALSE(follows(same, arcs, claim));
  ClearanceClaim wide = claim;
  wide.corner = 0.375;
  EXPECT_TRUE(follows(further, arcs, wide));
  EXPECT_EQ(claim_of(pipe_part({0, 0.25, 0}, {0, -9, 0}, 4), arcs).verdict, Verdict::undecided);
  EXPECT_GT(claim_of(pipe_part({0, -0.25, 0}, {0, -9, 0}, 4), arcs).distance, 0.2);
}

// Leaves with nothing in them, beyond the first surface or the loop, and without a direction of
// use.
std::vector<DiscPairs> leaves_that_fail(const Vec3& up, double beyond) {
  return {{{.5, .5}, {0, 1}, up},         {{0, 1}, {.5, .5}, up},        {{0, beyond}, {0, 1}, up},
          {{0, 1}, {0, 2.5}, up},         {{0, 1}, {0, 1}, {}},          {{0, 1}, {0, 1}, -up},
          {{0, 1}, {0, 1}, Vec3::Zero()}, {{0, 1}, {0, 1}, 0x1p301 * up}};
}

TEST(LoopClearance, of_loops_is_the_slab_between_them) {
  const LoopArcs low = hand_made(loop_of("through_0"), {0, 0, 0}),
                 high = hand_made(loop_of("through_1"), {0, 0, 3});
  const Vec3 up(0, 0, 2);
  std::vector<DiscPairs> leaves = all_leaves(up);
  for (const DiscPairs& leaf : all_leaves(up)) {
    leaves.push_back({{1, 2}, leaf.second, up});
  }
  EXPECT_TRUE(follows(low, high, apart(2.999, leaves)));
  EXPECT_FALSE(follows(low, high, apart(3.001, leaves)));
  EXPECT_FALSE(follows(high, low, apart(2.999, leaves)));
  EXPECT_FALSE(follows(low, high, apart(0, leaves)));
  EXPECT_FALSE(follows(low, high, apart(2.999, all_leaves(up))));
  EXPECT_FALSE(follows({low.loop, {}}, high, apart(1, leaves)));
  EXPECT_FALSE(follows(low, {high.loop, {}}, apart(1, leaves)));
  ClearanceClaim refuted = apart(2.999, leaves);
  refuted.verdict = Verdict::refuted;
  EXPECT_FALSE(follows(low, high, refuted));
  // Leaves more than are needed must hold, too.
  for (const DiscPairs& leaf : leaves_that_fail(up, 2.5)) {
    std::vector<DiscPairs> more = leaves;
    more.push_back(leaf);
    EXPECT_FALSE(follows(low, high, apart(2.999, more)));
  }
}

// In corners that are not the same, arcs move apart and may meet all the same.
TEST(LoopClearance, of_loops_without_common_corners_is_no_matter_of_corners) {
  const LoopArcs low = hand_made(loop_of("equal_0"), {0, 0, 0}),
                 same = hand_made(loop_of("equal_1"), {0, 0, 3});
  CanalFillet moved = loop_of("equal_1");
  std::get<RollingThrough>(moved.motion).origin.x() += 1;
  const LoopArcs other = hand_made(moved, {0, 0, 3});
  std::vector<DiscPairs> leaves;
  for (const ParameterInterval& t : {ParameterInterval{0, 1}, {1, 2}}) {
    for (const ParameterInterval& s : {ParameterInterval{0, 1}, {1, 2}}) {
      leaves.push_back({t, s, Vec3::UnitZ()});
    }
  }
  EXPECT_TRUE(follows(low, other, apart(1, leaves)));
  EXPECT_FALSE(follows(low, other, apart(0, leaves)));
  EXPECT_TRUE(follows(low, same, apart(0, leaves)));
  EXPECT_FALSE(follows(low, same, apart(1, leaves)));
  leaves.push_back({{.75, 1}, {1, 1.25}, Vec3::UnitX()});
  EXPECT_FALSE(follows(low, other, apart(1, leaves)));
  EXPECT_TRUE(follows(low, same, apart(0, leaves)));
}

TEST(LoopClearance, of_parts_is_the_slab_between_them_and_the_arcs) {
  const LoopArcs high = hand_made(loop_of("through_0"), {0, 0, 3});
  const Solid low(pipe_part({-2, 0, 0}, {2, 0, 0}, 1));
  const Vec3 up(0, 0, 2);
  const std::vector<DiscPairs> leaves = all_leaves(up);
  EXPECT_TRUE(follows(low, high, apart(1.999, leaves)));
  EXPECT_FALSE(follows(low, high, apart(2.001, leaves)));
  EXPECT_FALSE(follows(low, high, apart(0, leaves)));
  for (const DiscPairs& leaf : leaves_that_fail(up, 1.5)) {
    std::vector<DiscPairs> more = leaves;
    more.push_back(leaf);
    EXPECT_FALSE(follows(low, high, apart(1.999, more)));
  }
  CertifiedPart unknown;
  Chain chain;
  chain.joints = Joints::spherical;
  unknown.shape = chain;
  EXPECT_FALSE(follows(Solid(unknown), high, apart(1, {})));
}

// The middle of a bend's triangle reaches further than the bend.
TEST(LoopClearance, of_bends_may_take_shorter_stretches) {
  const Solid bend(part(Chain(test::elbow(4, 1.5, .25))));
  const Vec3 out(std::cos(.75), std::sin(.75), 0);
  const LoopArcs beyond = hand_made(loop_of("through_0"), 5 * out);
  EXPECT_TRUE(follows(bend, beyond, apart(.5, all_leaves(out))));
  EXPECT_FALSE(follows(bend, beyond, apart(.76, all_leaves(out))));
}

// Any of the three places that are looked at may be the only one in the part.
TEST(LoopClearance, of_what_overlaps_is_at_a_foot_or_in_the_middle) {
  const CanalFillet& loop = loop_of("through_0");
  const auto arcs = contact_arcs(loop, {.5, .5});
  ASSERT_TRUE(arcs);
  for (const IntervalVec& at : {arcs->corners[0], arcs->corners[1], arcs->middle}) {
    const Vec3 place = numbers::middle(at);
    const Solid small(ball_part(place, .01));
    const Overlap honest{place, {0, 1}, {.5, .5}};
    EXPECT_TRUE(follows(honest, small, loop));
    const std::vector<std::function<void(Overlap&)>> changes{
        [](Overlap& o) { o.point.x() = std::numeric_limits<double>::quiet_NaN(); },
        [](Overlap& o) { o.point.x() += .02; },
        [](Overlap& o) { o.first.to = 1.5; },
        [](Overlap& o) { o.second.to = .625; },
        [](Overlap& o) {
          o.second = {.375, .375};
        },
        [](Overlap& o) {
          o.second = {2.5, 2.5};
        }};
    for (std::size_t i = 0; i < changes.size(); ++i) {
      Overlap changed = honest;
      changes[i](changed);
      EXPECT_FALSE(follows(changed, small, loop)) << i;
    }
  }
  // Of a hollow part nothing is told by its discs.
  const Vec3 place = numbers::middle(arcs->middle), x = Vec3::UnitX();
  const PeArc arc = PeArc::from({place - 3 * x, 1}, {x, 0}, {place + 3 * x, 1});
  CertifiedPart pipe = test::part(test::cyclide_piece(arc));
  const Overlap inside{place, {.4375, .5625}, {.5, .5}};
  EXPECT_TRUE(follows(inside, Solid(pipe), loop));
  std::get<Chain>(pipe.shape).wall = .25;
  EXPECT_FALSE(follows(inside, Solid(pipe), loop));
}

}  // namespace
}  // namespace dupin::verification
