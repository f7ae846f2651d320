#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "blends/verification/least_bound_internal.h"
#include "blends/verification/solids_internal.h"
#include "dupin/blends/cyclide_tube.h"
#include "support/cyclide_cases.h"
#include "verification/claims/mesh_claim.h"

// Of hollow chains and of chains with kneecaps.
namespace dupin::verification {
namespace {

using std::numbers::pi;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> equal_knots(int pieces, int bands) {
  std::vector<double> knots;
  for (int i = 0; i <= pieces * bands; ++i) {
    knots.push_back(double(i) / bands);
  }
  return knots;
}

CertifiedPart part_of(const Chain& chain) {
  CertifiedPart result;
  result.shape = chain;
  return result;
}

Solid solid_of(const Chain& chain) { return Solid(part_of(chain)); }

double least_bound(const Solid& solid, MeshClaim about) {
  return least_bound(solid, std::move(about), 1, 2e-3);
}

PeArc quarter(double radius) {
  return PeArc::from(test::sphere(4, 0, 0, radius), test::direction(Vec3::UnitY(), 0),
                     test::sphere(0, 4, 0, radius));
}

Chain quarter_tube(double radius, double wall = 0) {
  Chain chain(test::cyclide_piece(quarter(radius)));
  chain.wall = wall;
  return chain;
}

MeshClaim hollow_claim(int outer, int inner, double error_bound = 1) {
  MeshClaim claim{64, 0, equal_knots(1, outer), error_bound};
  claim.inner_knots = equal_knots(1, inner);
  return claim;
}

TEST(MeshClaimOfSkins, is_of_both_skins_of_a_hollow_chain) {
  const Solid hollow = solid_of(quarter_tube(1, .5));
  const auto alone = [](double radius, int bands) {
    return least_bound(solid_of(quarter_tube(radius)), {64, 0, equal_knots(1, bands), 0});
  };
  const double outer = alone(1, 4), inner = alone(.5, 2);
  EXPECT_NEAR(least_bound(hollow, hollow_claim(4, 8)), outer, 5e-3 * outer);
  EXPECT_NEAR(least_bound(hollow, hollow_claim(8, 2)), inner, 5e-3 * inner);
  EXPECT_GT(inner, 1.5 * outer) << "the inner one has the larger error";
}

TEST(MeshClaimOfSkins, needs_knots_of_the_inner_skin_if_there_is_one) {
  const Solid hollow = solid_of(quarter_tube(1, .5)), full = solid_of(quarter_tube(1));
  EXPECT_TRUE(follows(hollow, hollow_claim(16, 16)));
  EXPECT_FALSE(follows(full, hollow_claim(16, 16)));
  for (const std::vector<double>& bad : std::vector<std::vector<double>>{
           {}, {0}, {0, .5}, {.5, 1}, {0, .75, .5, 1}, {0, .5, 1, 2}, {0, kNan, 1}}) {
    MeshClaim claim = hollow_claim(16, 16, 10);
    claim.inner_knots = bad;
    EXPECT_FALSE(follows(hollow, claim)) << bad.size();
  }
  MeshClaim claim = hollow_claim(16, 16);
  claim.knots.clear();
  EXPECT_FALSE(follows(hollow, claim));
  EXPECT_FALSE(follows(test::ball({0, 0, 0}, 1), claim)) << "of no chain";
}

// Between circles of which one is inside out, the quadrilaterals of a rim are none.
TEST(MeshClaimOfSkins, has_rims_between_circles) {
  EXPECT_TRUE(follows(solid_of(quarter_tube(1, .99)), hollow_claim(16, 16, 10)));
  EXPECT_FALSE(follows(solid_of(quarter_tube(1, 1.01)), hollow_claim(16, 16, 10)));
  const auto growing = [](double from, double to) {
    Chain chain(test::cyclide_piece(PeArc::from(test::sphere(0, 0, 0, from),
                                                test::direction(Vec3::UnitX(), 0),
                                                test::sphere(9, 0, 0, to))));
    chain.wall = .5;
    return chain;
  };
  EXPECT_TRUE(follows(solid_of(growing(.6, 1)), hollow_claim(16, 16, 10)));
  EXPECT_FALSE(follows(solid_of(growing(.4, 1)), hollow_claim(16, 16, 10)));
  EXPECT_FALSE(follows(solid_of(growing(1, .4)), hollow_claim(16, 16, 10)));
  Chain closed = quarter_tube(1, .5);
  closed.closed = true;
  EXPECT_FALSE(follows(solid_of(closed), hollow_claim(16, 16, 10))) << "it has no ends";
}

MeshClaim knee_claim(const Chain& chain, int bands, const KneecapMesh& knees,
                     std::uint32_t segments = 64) {
  MeshClaim claim{segments, 0, equal_knots(int(chain.pieces.size()), bands), 10};
  claim.kneecaps = knees;
  return claim;
}

Chain arm() { return kneecap_chain(test::lune_spheres()); }

TEST(MeshClaimOfSkins, of_kneecaps_is_that_of_their_pieces_and_balls) {
  const Solid solid = solid_of(arm());
  EXPECT_TRUE(follows(solid, knee_claim(arm(), 16, {0, 0, {64}})));
  const double fine = least_bound(solid, knee_claim(arm(), 8, {0, 0, {1'000'000}}));
  EXPECT_NEAR(least_bound(solid, knee_claim(arm(), 8, {0, 0, {64}})), fine, 5e-3 * fine);
  // The ball has the radius 1.
  for (const std::uint32_t segments : {3U, 7U}) {
    const double depth = 1 - std::cos(pi / segments);
    ASSERT_GT(depth, fine);
    MeshClaim claim = knee_claim(arm(), 8, {0, 0, {segments}});
    claim.error_bound = depth + 1e-12;
    EXPECT_TRUE(follows(solid, claim)) << segments;
    claim.error_bound = depth - 1e-12;
    EXPECT_FALSE(follows(solid, claim)) << segments;
  }
}

// Where the turn is what other chains share among their bands, the bound is theirs.
TEST(MeshClaimOfSkins, of_kneecaps_includes_how_columns_turn) {
  Chain single = kneecap_chain(std::vector<PeVector>{
      test::sphere(0, 0, 0, 1), test::sphere(2, 1, 0, .8), test::sphere(4, 1, 0, 1)});
  const Solid knees = solid_of(single);
  const double shared = pi / 16 / 4;
  const double with_turn = least_bound(knees, knee_claim(single, 4, {shared, 0, {}}, 16));
  EXPECT_LT(least_bound(knees, knee_claim(single, 4, {0, 0, {}}, 16)), .99 * with_turn);
  EXPECT_GT(least_bound(knees, knee_claim(single, 4, {2 * shared, 0, {}}, 16)), 1.01 * with_turn);
  single.joints = Joints::smooth;
  const double plain = least_bound(solid_of(single), {16, 0, equal_knots(1, 4), 0});
  EXPECT_NEAR(with_turn, plain, 5e-3 * plain);
}

TEST(MeshClaimOfSkins, of_kneecaps_includes_what_counts_as_one) {
  const Solid solid = solid_of(arm());
  const double least = least_bound(solid, knee_claim(arm(), 8, {0, 0, {64}}));
  MeshClaim claim = knee_claim(arm(), 8, {0, .25, {64}});
  claim.error_bound = least + .251;
  EXPECT_TRUE(follows(solid, claim));
  claim.error_bound = .99 * least + .25;
  EXPECT_FALSE(follows(solid, claim));
}

TEST(MeshClaimOfSkins, of_kneecaps_says_all_that_the_bound_needs) {
  const Solid solid = solid_of(arm());
  const std::vector<KneecapMesh> bad{{-1e-9, 0, {64}}, {kNan, 0, {64}},
                                     {1e301, 0, {64}}, {0, -1e-9, {64}},
                                     {0, kNan, {64}},  {0, 0, {}},
                                     {0, 0, {64, 64}}, {0, 0, {2}},
                                     {0, 0, {0}},      {0, 0, {CertificateLimits::kSegments + 1}}};
  for (std::size_t i = 0; i < bad.size(); ++i) {
    EXPECT_FALSE(follows(solid, knee_claim(arm(), 16, bad[i]))) << i;
  }
  MeshClaim silent = knee_claim(arm(), 16, {0, 0, {64}});
  silent.kneecaps.reset();
  EXPECT_FALSE(follows(solid, silent));
  const Solid smooth = solid_of(quarter_tube(1));
  EXPECT_TRUE(follows(smooth, {64, 0, equal_knots(1, 16), 10}));
  EXPECT_FALSE(follows(smooth, knee_claim(quarter_tube(1), 16, {0, 0, {}})));
  MeshClaim of_ball{64, 0, {}, 1};
  EXPECT_TRUE(follows(test::ball({0, 0, 0}, 1), of_ball));
  of_ball.kneecaps.emplace();
  EXPECT_FALSE(follows(test::ball({0, 0, 0}, 1), of_ball));
}

TEST(MeshClaimOfSkins, of_hollow_kneecaps_is_of_both_balls) {
  Chain chain = arm();
  chain.wall = .25;
  const Solid solid = solid_of(chain);
  const auto claim = [&](std::uint32_t outer, std::uint32_t inner) {
    MeshClaim result = knee_claim(chain, 16, {0, 0, {outer, inner}});
    result.inner_knots = result.knots;
    return result;
  };
  const double depth = 1 - std::cos(pi / 5);
  const auto is_bound_by = [&](MeshClaim about, double bound) {
    about.error_bound = bound + 1e-9;
    EXPECT_TRUE(follows(solid, about));
    about.error_bound = bound - 1e-9;
    EXPECT_FALSE(follows(solid, about));
  };
  is_bound_by(claim(5, 64), depth);
  is_bound_by(claim(64, 5), .75 * depth);
  EXPECT_FALSE(follows(solid, knee_claim(chain, 16, {0, 0, {64, 64}}))) << "the inner skin's rows";
}

// A joint's ball has its centre further out than the circles there have, or further in.
TEST(MeshClaimOfSkins, is_about_coordinates_as_large_as_those_of_the_balls) {
  std::vector<PeVector> spheres{test::sphere(-4, 0, 0, 3), test::sphere(0, 0, 0, 2.9),
                                test::sphere(9, 1, 0, 6), test::sphere(5, 9, 0, 2),
                                test::sphere(0, 12, 0, 1)};
  const double out = size_of(solid_of(kneecap_chain(spheres)));
  EXPECT_GE(out, spheres[2].m.norm());
  EXPECT_LE(out, 2 * 12);
  const Vec3 joint = spheres[2].m;
  for (PeVector& sphere : spheres) {
    sphere.m -= joint;
  }
  EXPECT_GE(size_of(solid_of(kneecap_chain(spheres))), spheres[0].m.norm() - spheres[0].r);
}

}  // namespace
}  // namespace dupin::verification
