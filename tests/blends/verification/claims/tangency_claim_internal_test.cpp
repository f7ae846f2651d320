#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "dupin/blends/rational_ringed_surface.h"
#include "dupin/blends/ringed_blend.h"
#include "support/cyclide_cases.h"
#include "support/paper_surfaces.h"
#include "verification/claims/tangency_claim.h"

namespace dupin::verification {
namespace {

constexpr double kRounding = 1e-14;

TangencyClaim claim(double deviation, double axis_angle = kRounding, double offset = kRounding) {
  return {deviation, axis_angle, offset, {}};
}

bool at_end(const Solid& solid, const TangencyClaim& about) {
  return follows(solid.pieces().front(), about, End::end);
}

bool at_start(const Solid& solid, const TangencyClaim& about) {
  return follows(solid.pieces().front(), about, End::start);
}

// What follows for slightly more than the value, and not for slightly less.
void expect_bound(const std::function<bool(double)>& follows, double value) {
  EXPECT_TRUE(follows(value * (1 + 1e-9) + kRounding)) << value;
  EXPECT_FALSE(follows(value * (1 - 1e-9) - kRounding)) << value;
}

TEST(TangencyClaim, of_tubes_that_go_on_is_rounding) {
  for (const RingedSurface& surface :
       {test::cylinder({0, 0, 0}, {3, 1, 2}, 1), test::cone({0, 0, 0}, {3, 1, 2}, 1, .5),
        test::elbow(4, 1.5, 1), test::figure6(), test::figure6(CyclideRadius{1, 2})}) {
    const Solid solid = test::solid(surface);
    EXPECT_TRUE(at_start(solid, claim(kRounding)));
    EXPECT_TRUE(at_end(solid, claim(kRounding)));
  }
  // Of numbers without rounding it is nothing at all.
  const Solid exact = test::solid(test::cylinder({0, 0, 0}, {3, 0, 0}, 1));
  EXPECT_TRUE(at_start(exact, claim(0, 0, 1e-300)));
  EXPECT_FALSE(at_start(exact, claim(-1e-300, 0, 1e-300)));
  EXPECT_FALSE(at_start(exact, claim(0, -1e-300, 1e-300)));
  EXPECT_FALSE(at_start(exact, claim(0, 0, -1e-300)));
}

// By as much as the tube would be off at its other end.
TEST(TangencyClaim, is_near_if_all_of_the_piece_is) {
  const Ring ring{Vec3::Zero(), Vec3::UnitX(), 2, 0};
  EXPECT_TRUE(is_near({{}, .001, .02, {}}, ring, 30, .0501));
  EXPECT_FALSE(is_near({{}, .001, .02, {}}, ring, 30, .0499));
  EXPECT_FALSE(is_near({{}, .001, .02, {}}, ring, 31, .0501));
  const double unknown = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_near({{}, .001, .02, {}}, ring, unknown, .0221));
  EXPECT_FALSE(is_near({{}, .001, .02, {}}, ring, unknown, .0219));
  EXPECT_TRUE(is_near({{}, 0, .02, {}}, ring, 1e300, .0201));
  EXPECT_FALSE(is_near({{}, 0x1p-60, 1, {}}, ring, 2, 1)) << "by less than rounding";
}

// A certificate may state any tolerance.
TEST(TangencyClaim, is_near_no_further_than_its_ring_is_wide) {
  Ring ring{Vec3::Zero(), Vec3::UnitX(), 2, 0};
  EXPECT_TRUE(is_near({{}, 0, 1.999, {}}, ring, 30, 1e9));
  EXPECT_FALSE(is_near({{}, 0, 2.001, {}}, ring, 30, 1e9));
  EXPECT_FALSE(is_near({{}, .07, 0, {}}, ring, 30, 1e9));
  ring.ellipse = Ellipse{Vec3::UnitY(), 1, 0};
  EXPECT_TRUE(is_near({{}, 0, .999, {}}, ring, 30, 1e9));
  EXPECT_FALSE(is_near({{}, 0, 1.001, {}}, ring, 30, 1e9));
}

TEST(TangencyClaim, is_about_the_moved_centre_and_the_radius) {
  RingedSurface surface = test::cylinder({0, 0, 0}, {3, 0, 0}, 1);
  surface.end.center = Vec3(3, .003, .004);
  expect_bound([&](double x) { return at_end(test::solid(surface), claim(0, 0, x)); }, .005);
  surface.end.radius = 1.001;
  expect_bound([&](double x) { return at_end(test::solid(surface), claim(0, 0, x)); }, .006);
  EXPECT_TRUE(at_start(test::solid(surface), claim(0, 0, 1e-300)));
}

TEST(TangencyClaim, is_about_the_angle_to_the_rings_normal) {
  RingedSurface surface = test::cylinder({0, 0, 0}, {3, 0, 0}, 1);
  surface.start.normal = Vec3(-std::cos(.01), std::sin(.01), 0);
  expect_bound([&](double x) { return at_start(test::solid(surface), claim(0, x)); }, .01);
  surface.start.normal = Vec3::UnitX();  // into the part
  expect_bound([&](double x) { return at_start(test::solid(surface), claim(0, x)); },
               std::numbers::pi);
}

TEST(TangencyClaim, is_about_the_angle_to_the_wall) {
  RingedSurface surface = test::cone({0, 0, 0}, {4, 0, 0}, 1, 2);
  surface.end.slope = 0;  // a cylinder goes on
  expect_bound([&](double x) { return at_end(test::solid(surface), claim(x)); }, std::atan(.25));
  surface.end.slope = 1;
  expect_bound([&](double x) { return at_end(test::solid(surface), claim(x)); },
               std::atan(1) - std::atan(.25));
  surface.start.slope = 0;
  expect_bound([&](double x) { return at_start(test::solid(surface), claim(x)); }, std::atan(.25));
  // Where the tube bends, the wall inside is the steeper one.
  RingedSurface bend = test::elbow(4, 1.5, 1);
  bend.radius = LinearRadius{1, 2};
  bend.start.slope = 0;
  expect_bound([&](double x) { return at_start(test::solid(bend), claim(x)); },
               std::atan2(1, 1.5 * (4 - 1)));
}

TEST(TangencyClaim, of_a_folded_end_is_half_a_turn) {
  const Solid folded = test::solid(test::elbow(1, 1.5, 2));
  EXPECT_FALSE(at_end(folded, claim(3.14)));
  EXPECT_TRUE(at_end(folded, claim(3.15)));
}

TEST(TangencyClaim, of_elliptic_tubes_is_about_both_axes) {
  EllipticTube tube;
  tube.start = {Vec3(0, 0, 0), -Vec3::UnitX(), 2, 0, Ellipse{Vec3::UnitY(), 1, 0}};
  tube.end = {Vec3(5, 0, 0), Vec3::UnitX(), 2, 0, Ellipse{Vec3::UnitY(), 1, 0}};
  tube.spine = LineSpine{Vec3(0, 0, 0), Vec3(5, 0, 0)};
  tube.first = ConstantRadius{2};
  tube.second = ConstantRadius{1};
  tube.axis = Vec3::UnitY();
  EXPECT_TRUE(at_end(test::solid(tube), claim(kRounding)));
  EllipticTube other = tube;
  other.end.ellipse->across = 1.125;
  EXPECT_FALSE(at_end(test::solid(other), claim(kRounding)));
  EXPECT_TRUE(at_end(test::solid(other), claim(kRounding, kRounding, .1251)));
  other = tube;
  other.end.ellipse->across_slope = .25;
  EXPECT_FALSE(at_end(test::solid(other), claim(std::atan(.25))));
  EXPECT_TRUE(at_end(test::solid(other), claim(1.01 * .25 * std::numbers::pi / 2)));
  TangencyClaim bent = claim(kRounding);
  bent.curvature = 100;  // not claimed of these
  EXPECT_FALSE(at_end(test::solid(tube), bent));
}

TEST(TangencyClaim, of_cyclides_is_rounding_until_their_rings_are_moved) {
  test::RandomArcs arcs;
  for (int i = 0; i < 10; ++i) {
    const CyclidePiece piece = test::cyclide_piece(arcs.next());
    const Solid solid = test::solid(piece);
    EXPECT_TRUE(at_start(solid, claim(1e-10, 1e-10, 1e-10)));
    EXPECT_TRUE(at_end(solid, claim(1e-10, 1e-10, 1e-10)));
    CyclidePiece moved = piece;
    moved.end.center.x() += 1e-8;
    EXPECT_FALSE(at_end(test::solid(moved), claim(1e-10, 1e-10, 5e-9)));
    moved = piece;
    moved.end.slope += 1e-4;
    EXPECT_FALSE(at_end(test::solid(moved), claim(1e-6, 1e-10, 1e-10)));
    moved = piece;
    moved.start.radius += 1e-8;
    EXPECT_FALSE(at_start(test::solid(moved), claim(1e-10, 1e-10, 5e-9)));
    moved = piece;
    moved.last.r += 1e-6;
    EXPECT_FALSE(at_end(test::solid(moved), claim(1e-10, 1e-10, 1e-10)));
    EXPECT_TRUE(at_start(test::solid(moved), claim(1e-10, 1e-10, 1e-10)));
  }
}

// What is not claimed is not proved: parts are said to be tangent at their ends.
TEST(TangencyClaim, of_other_pieces_has_a_deviation) {
  TangencyClaim without = claim(1);
  without.deviation.reset();
  for (const Solid& solid : {test::solid(test::cylinder({0, 0, 0}, {3, 0, 0}, 1)),
                             test::solid(test::elbow(4, 1.5, 1)), test::solid(test::figure6())}) {
    EXPECT_TRUE(at_start(solid, claim(1)));
    EXPECT_FALSE(at_start(solid, without));
    EXPECT_FALSE(at_end(solid, without));
  }
}

TEST(TangencyClaim, of_rational_tubes_has_no_deviation) {
  const RationalRingedTube tube = oblique_tube(Vec3(0, 0, 0), Vec3(3, 0, 1), Vec3(1, 0, 0), 1, .5);
  const Solid solid = test::solid(tube);
  TangencyClaim without = claim(0);
  without.deviation.reset();
  EXPECT_TRUE(at_end(solid, without));
  EXPECT_TRUE(at_start(solid, without));
  EXPECT_FALSE(at_end(solid, claim(3.15)));
  RationalRingedTube moved = tube;
  moved.end.center.z() += 1e-9;
  EXPECT_FALSE(at_end(test::solid(moved), without));
  EXPECT_TRUE(at_start(test::solid(moved), without));
  moved = tube;
  moved.start.normal = Vec3(-std::cos(.01), std::sin(.01), 0);
  EXPECT_FALSE(at_start(test::solid(moved), without));
}

TEST(TangencyClaim, curvature_of_an_elbow_is_at_least_that_of_its_inside) {
  const auto bent = [](double curvature) {
    TangencyClaim result = claim(kRounding);
    result.curvature = curvature;
    return result;
  };
  for (const double bend : {2., 4.}) {
    // kappa / (1 - kappa R); the verifier lets q = v (1 -+ kappa R) vary on its own.
    const Solid elbow = test::solid(test::elbow(bend, 1.5, 1));
    const double x = 1 / bend, inside = 1 / (bend - 1);
    EXPECT_FALSE(at_end(elbow, bent(.99 * inside)));
    EXPECT_TRUE(at_end(elbow, bent(1.01 * inside * std::pow((1 + x) / (1 - x), 2))));
  }
  const Solid pipe = test::solid(test::cylinder({0, 0, 0}, {3, 1, 2}, 1));
  EXPECT_TRUE(at_end(pipe, bent(0)));
  EXPECT_FALSE(at_end(pipe, bent(-1)));
  EXPECT_FALSE(at_end(pipe, bent(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_FALSE(at_end(test::solid(test::elbow(1, 1.5, 2)), bent(1e9)));  // folded
}

TEST(TangencyClaim, curvature_is_that_of_the_end_it_is_about) {
  RingedSurface growing = test::elbow(8, 1, 1);
  growing.radius = BezierRadius{{1, 1, 1, 4, 4, 4}};  // constant near its ends
  growing.end.radius = 4;
  TangencyClaim bent = claim(1, kRounding, 1);
  bent.curvature = .24;  // more than 1/(8 - 1) with the verifier's room, less than 1/(8 - 4)
  EXPECT_TRUE(at_start(test::solid(growing), bent));
  EXPECT_FALSE(at_end(test::solid(growing), bent));
}

// Though the wall that widens there is smooth by its formula.
TEST(TangencyClaim, curvature_of_a_folded_end_is_not_bounded) {
  RingedSurface folded = test::elbow(1, 1.5, 2);
  folded.radius = LinearRadius{2, 3};
  TangencyClaim bent = claim(4, kRounding, 9);
  EXPECT_TRUE(at_end(test::solid(folded), bent));
  bent.curvature = 1e9;
  EXPECT_FALSE(at_end(test::solid(folded), bent));
}

TEST(TangencyClaim, without_a_bound_never_follows) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Solid pipe = test::solid(test::cylinder({0, 0, 0}, {3, 1, 2}, 1));
  EXPECT_FALSE(at_end(pipe, claim(none)));
  EXPECT_FALSE(at_end(pipe, claim(kRounding, none)));
  EXPECT_FALSE(at_end(pipe, claim(kRounding, kRounding, none)));
}

}  // namespace
}  // namespace dupin::verification
