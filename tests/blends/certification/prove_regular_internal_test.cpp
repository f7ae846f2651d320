#include <cmath>

#include <gtest/gtest.h>

#include "blends/tubes.h"
#include "certification/prove_regular.h"
#include "dupin/blends/cyclide_piece.h"
#include "dupin/blends/cyclide_tube.h"

namespace dupin::certification {
namespace {

using test::cylinder;
using test::elbow;

// A quarter torus of bend radius 4 whose circles grow from radius 1 to 2: 1 - R / 4.
RingedSurface widening() {
  RingedSurface tube = elbow(4, std::acos(0.0), 1);
  tube.end.radius = 2;
  tube.radius = LinearRadius{1, 2};
  return tube;
}

// They cover all parameters, one after the other.
void expect_cover(const RegularClaim& claim, double length) {
  double at = 0;
  for (const ParameterInterval& leaf : claim.leaves) {
    EXPECT_EQ(leaf.from, at);
    EXPECT_GT(leaf.to, leaf.from);
    at = leaf.to;
  }
  EXPECT_EQ(at, length);
}

TEST(ProveRegular, finds_nearly_the_largest_margin_of_all_pieces) {
  const RingedSurface pipe = cylinder(Vec3(4, -3, 0), Vec3(4, 0, 0), 1);
  const struct {
    std::vector<RingedSurface> pieces;
    double exact;
  } rows[] = {
      {{pipe}, 1},
      {{elbow(4, 1, 1)}, 0.75},
      {{widening()}, 0.5},
      {{pipe, elbow(4, 1, 1)}, 0.75},
      {{pipe, elbow(4, 1, 3), elbow(4, 1, 1)}, 0.25},
      {{elbow(4, 1, 1), pipe, elbow(4, 1, 3)}, 0.25},
  };
  for (const auto& row : rows) {
    const RegularClaim claim = prove_regular(Chain(row.pieces), {});
    EXPECT_EQ(claim.verdict, Verdict::proved);
    EXPECT_LT(claim.margin, row.exact) << "more than the margin";
    EXPECT_GT(claim.margin, row.exact - 0.02);
    expect_cover(claim, static_cast<double>(row.pieces.size()));
  }
}

TEST(ProveRegular, proves_the_margin_it_is_told) {
  const Chain chain(std::vector{elbow(4, 1, 1), widening()});
  for (const double margin : {0.0, 0.25, 0.499}) {
    const RegularClaim claim = prove_regular(chain, margin);
    EXPECT_EQ(claim.verdict, Verdict::proved);
    EXPECT_EQ(claim.margin, margin);
    expect_cover(claim, 2);
  }
}

// 1 - R / 4 > margin fails from R = 4 (1 - margin) on.
TEST(ProveRegular, refutes_a_margin_at_a_place_where_it_fails) {
  for (const double margin : {0.501, 0.6, 0.7}) {
    const RegularClaim claim =
        prove_regular(Chain(std::vector{elbow(4, 1, 1), widening()}), margin);
    EXPECT_EQ(claim.verdict, Verdict::refuted);
    EXPECT_EQ(claim.margin, margin);
    EXPECT_TRUE(claim.leaves.empty());
    const double fails_from = 1 + (4 * (1 - margin) - 1);
    EXPECT_GE(std::max(claim.where.from, claim.where.to), fails_from);
    EXPECT_GE(claim.where.from, 1) << "the first piece is regular";
    EXPECT_LE(claim.where.to, 2);
  }
}

// A quarter of a torus of radii 4 and 2; the skin inside has a radius of 2 - wall.
TEST(ProveRegular, looks_at_both_skins_of_a_hollow_chain) {
  const PeVector start{Vec3(4, 0, 0), 2}, end{Vec3(0, 4, 0), 2};
  const CyclideChain torus{{PeArc::from(start, {Vec3::UnitY(), 0}, end)}};
  const RegularClaim thin = prove_regular(cyclide_tube(torus, 0.5), {});
  EXPECT_EQ(thin.verdict, Verdict::proved);
  EXPECT_LT(thin.margin, 0.5);
  EXPECT_GT(thin.margin, 0.9 * 0.5);
  expect_cover(thin, 1);
  Chain too_thick = cyclide_tube(torus, 0.5);
  too_thick.wall = 2.5;
  EXPECT_NE(prove_regular(too_thick, {}).verdict, Verdict::proved);
}

// An arm that flares towards its hub.
TEST(ProveRegular, of_a_straight_piece_of_a_cyclide_takes_few_leaves) {
  const PeArc arc = PeArc::from({Vec3::Zero(), 2}, {Vec3::UnitX(), 0}, {Vec3(5.4, 0, 0), 5.53});
  const RegularClaim claim = prove_regular(Chain(cyclide_piece(arc)), {});
  EXPECT_EQ(claim.verdict, Verdict::proved);
  EXPECT_LE(claim.leaves.size(), 4U);
  expect_cover(claim, 1);
}

}  // namespace
}  // namespace dupin::certification
