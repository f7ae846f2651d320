#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "dupin/blends/rational_ringed_surface.h"
#include "dupin/blends/ringed_blend.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"
#include "support/paper_surfaces.h"
#include "verification/claims/regular_claim.h"

namespace dupin::verification {
namespace {

RegularClaim proved(double margin, const std::vector<ParameterInterval>& leaves = {{0, 1}}) {
  return {Verdict::proved, margin, leaves, {}};
}

RegularClaim refuted(double margin, const ParameterInterval& where = {0, 1}) {
  return {Verdict::refuted, margin, {}, where};
}

std::vector<ParameterInterval> equal_leaves(int count) {
  std::vector<ParameterInterval> leaves;
  for (int i = 0; i < count; ++i) {
    leaves.push_back({double(i) / count, double(i + 1) / count});
  }
  return leaves;
}

TEST(RegularClaim, of_a_straight_tube_follows_for_every_margin_below_one) {
  for (const Solid& solid : {test::solid(test::cylinder({0, 0, 0}, {5, 1, 2}, 3)),
                             test::solid(test::cone({0, 0, 0}, {5, 1, 2}, 3, .5))}) {
    EXPECT_TRUE(follows(solid, proved(0)));
    EXPECT_TRUE(follows(solid, proved(.999)));
    EXPECT_FALSE(follows(solid, refuted(.999)));
  }
}

// 1 - kappa R = 1 - 1 / 4 all along.
TEST(RegularClaim, of_an_elbow_follows_up_to_its_margin) {
  const Solid solid = test::solid(test::elbow(4, 1.5, 1));
  EXPECT_TRUE(follows(solid, proved(.749)));
  EXPECT_FALSE(follows(solid, proved(.751)));
  EXPECT_TRUE(follows(solid, refuted(.751)));
  EXPECT_FALSE(follows(solid, refuted(.749)));
  EXPECT_FALSE(follows(test::solid(test::elbow(4, 1.5, 4.5)), proved(0)));
  EXPECT_TRUE(follows(test::solid(test::elbow(4, 1.5, 4.5)), refuted(0)));
}

TEST(RegularClaim, of_an_elbow_is_exact_at_its_margin) {
  const Solid solid = test::solid(test::elbow(4, 1.5, 1));
  EXPECT_FALSE(follows(solid, proved(.75)));
  EXPECT_TRUE(follows(solid, refuted(.75)));
}

// An axis as long as is admitted makes the arc an ellipse of semi-axes 4 and 4 + 3.2e-9.
TEST(RegularClaim, of_an_arc_allows_for_all_that_its_axis_may_be) {
  RingedSurface surface = test::elbow(4, 1.5, 1);
  std::get<ArcSpine>(surface.spine).axis *= 1 + 8e-10;
  const Solid solid = test::solid(surface);
  EXPECT_TRUE(follows(solid, proved(.75 - 1e-9)));
  EXPECT_FALSE(follows(solid, proved(.75 - 1e-10)));
  EXPECT_TRUE(follows(solid, refuted(.75 + 1e-9)));
  EXPECT_FALSE(follows(solid, refuted(.75 + 2e-10)));
}

// From 1 - 1 / 4 at the start to 1 - 2 / 4 at the end.
TEST(RegularClaim, of_a_reducing_elbow_is_about_its_largest_radius) {
  RingedSurface surface = test::elbow(4, 1.5, 1);
  for (const RadiusLaw& law : {RadiusLaw(LinearRadius{1, 2}), RadiusLaw(CyclideRadius{1, 2})}) {
    surface.radius = law;
    const Solid solid = test::solid(surface);
    EXPECT_TRUE(follows(solid, proved(.49)));
    EXPECT_FALSE(follows(solid, proved(.6)));
    EXPECT_TRUE(follows(solid, refuted(.6, {.25, 1})));
    EXPECT_FALSE(follows(solid, refuted(.6, {0, .25})));
  }
}

// Figure 6 of [MS06]: the margin is 0.0848584660472, at t = 0.7344...
TEST(RegularClaim, of_figure_6_follows_up_to_its_margin) {
  for (const RadiusLaw& law : {RadiusLaw(CubicRadius{1, 2}), RadiusLaw(CyclideRadius{1, 2})}) {
    const Solid solid = test::solid(test::figure6(law));
    EXPECT_TRUE(follows(solid, proved(.04, equal_leaves(64))));
    EXPECT_FALSE(follows(solid, proved(.2, equal_leaves(64))));
  }
  const Solid solid = test::solid(test::figure6());
  EXPECT_TRUE(follows(solid, proved(.0848, equal_leaves(512))));
  EXPECT_FALSE(follows(solid, proved(.0849, equal_leaves(512))));
  const Solid folded = test::solid(test::figure5());  // for t in (0.659510, 0.787708)
  EXPECT_TRUE(follows(folded, refuted(0, {.7, .75})));
  EXPECT_FALSE(follows(folded, refuted(0, {.5, .6})));
}

TEST(RegularClaim, needs_leaves_that_cover_the_part_in_order) {
  const Solid solid =
      test::solid(test::cylinder({0, 0, 0}, {1, 0, 0}, 1), test::cylinder({1, 0, 0}, {2, 0, 0}, 1));
  EXPECT_TRUE(follows(solid, proved(.5, {{0, 1}, {1, 2}})));
  EXPECT_TRUE(follows(solid, proved(.5, {{0, .5}, {.5, 1}, {1, 2}})));
  const std::vector<std::vector<ParameterInterval>> bad{
      {},
      {{0, 1}},                      // not to the end
      {{1, 2}},                      // not from the start
      {{0, 2}},                      // over two pieces
      {{0, .5}, {.625, 1}, {1, 2}},  // a gap
      {{0, .5}, {.5, .5}, {.5, 1}, {1, 2}},
      {{1, 2}, {0, 1}},
      {{0, 1}, {1, 2}, {2, 3}},
      {{0, 1}, {1, std::numeric_limits<double>::quiet_NaN()}}};
  for (std::size_t i = 0; i < bad.size(); ++i) {
    EXPECT_FALSE(follows(solid, proved(.5, bad[i]))) << i;
  }
}

TEST(RegularClaim, needs_a_margin_in_the_unit_interval) {
  const Solid solid = test::solid(test::cylinder({0, 0, 0}, {1, 0, 0}, 1));
  for (const double margin : {-.1, 1., 2., std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(follows(solid, proved(margin)));
    EXPECT_FALSE(has_form(solid, {Verdict::undecided, margin, {}, {}}));
  }
}

TEST(RegularClaim, needs_positive_radii) {
  RingedSurface surface = test::cylinder({0, 0, 0}, {1, 0, 0}, 1);
  for (const RadiusLaw& law : {RadiusLaw(ConstantRadius{0}), RadiusLaw(ConstantRadius{-1}),
                               RadiusLaw(LinearRadius{1, -1})}) {
    surface.radius = law;
    EXPECT_THROW((void)test::solid(surface), Error);
  }
  for (const std::vector<double>& coefficients :
       {std::vector<double>{1, -3, 1}, {0}, {-1}, {1, -1}}) {
    surface.radius = BezierRadius{coefficients};
    EXPECT_FALSE(follows(test::solid(surface), proved(0)));
    EXPECT_FALSE(follows(test::solid(surface), proved(0, equal_leaves(16))));
  }
}

TEST(RegularClaim, of_an_elliptic_tube_is_about_the_larger_axis) {
  EllipticTube tube;
  const RingedSurface about = test::elbow(4, 1.5, 2);
  tube.start = about.start;
  tube.end = about.end;
  tube.spine = about.spine;
  tube.first = ConstantRadius{1};
  tube.second = ConstantRadius{2};
  tube.axis = Vec3::UnitZ();
  EXPECT_TRUE(follows(test::solid(tube), proved(.49)));
  EXPECT_FALSE(follows(test::solid(tube), proved(.51)));
  // An ellipse may keep clear where the circle about it does not.
  EXPECT_FALSE(follows(test::solid(tube), refuted(.51)));
}

TEST(RegularClaim, of_a_torus_given_as_a_cyclide_is_that_of_the_elbow) {
  // A quarter of the torus of radii 4 and 1.
  const PeArc arc = PeArc::from(test::sphere(4, 0, 0, 1), test::direction(Vec3::UnitY(), 0),
                                test::sphere(0, 4, 0, 1));
  CertifiedPart part = test::part(test::cyclide_piece(arc));
  EXPECT_TRUE(follows(Solid(part), proved(.7, equal_leaves(8))));
  EXPECT_FALSE(follows(Solid(part), proved(.76, equal_leaves(8))));
  // Inside, the margin is larger: both skins are claimed.
  std::get<Chain>(part.shape).wall = .5;
  EXPECT_TRUE(follows(Solid(part), proved(.7, equal_leaves(8))));
  std::get<Chain>(part.shape).wall = 1.25;
  EXPECT_FALSE(follows(Solid(part), proved(.7, equal_leaves(8))));
}

TEST(RegularClaim, of_a_rational_tube_follows_up_to_its_margin) {
  // Nothing turns, so only the radius could fail.
  const auto tube = oblique_tube(Vec3(0, 0, 0), Vec3(3, 0, 1), Vec3(1, 0, 0), 1, .5);
  EXPECT_TRUE(follows(test::solid(tube), proved(.9)));
  auto vanishing = tube;
  vanishing.surface.radius = {1, 0, -1, 1};
  EXPECT_FALSE(follows(test::solid(vanishing), proved(0)));
  auto standing = tube;
  standing.surface.center.fill(Vec3::Zero());
  EXPECT_FALSE(follows(test::solid(standing), proved(0)));
  // Negative on less than a leaf is divided into.
  vanishing.surface.radius = {1, -1. / 3 - 1e-5, -1. / 3 - 1e-5, 1};
  EXPECT_FALSE(follows(test::solid(vanishing), proved(0)));
  vanishing.surface.radius = {0, 1, 1, 1};
  EXPECT_FALSE(follows(test::solid(vanishing), proved(0)));
  // Out of a plate the circle's centre stands still: only the limit of the quotient says more.
  const Ring plate{Vec3(0, 0, 0), -Vec3::UnitZ(), 2}, pipe{Vec3(0, 0, 4), Vec3::UnitZ(), 1};
  const RationalRingedTube out{plate, pipe,
                               ringed_blend(along_plate({plate.center, Vec3::UnitZ(), 2}, -3),
                                            along_canal({pipe.center, pipe.normal, 1}, 0, 4))};
  EXPECT_TRUE(follows(test::solid(out), proved(.5, equal_leaves(4))));
}

TEST(RegularClaim, is_never_refuted_between_pieces_or_of_a_ball) {
  const Solid chain = test::solid(test::elbow(1, 1, 2), test::elbow(1, 1, 2));
  EXPECT_TRUE(follows(chain, refuted(0, {1, 2})));
  EXPECT_FALSE(follows(chain, refuted(0, {.5, 1.5})));
  EXPECT_FALSE(follows(test::ball({0, 0, 0}, 1), proved(0)));
  EXPECT_FALSE(follows(test::ball({0, 0, 0}, 1), refuted(0)));
}

}  // namespace
}  // namespace dupin::verification
