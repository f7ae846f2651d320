#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "certification/mesh_claims.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/spline_pipe.h"
#include "support/cyclide_cases.h"
#include "verification/claims/mesh_claim.h"

namespace dupin::certification {
namespace {

constexpr RingSampling kSampling{48, 0.3, 0x1p-16};

bool follows(const PartSurface& shape, const MeshClaim& claim) {
  CertifiedPart part;
  part.shape = shape;
  return verification::follows(verification::Solid(part), claim);
}

TEST(MeshClaims, of_a_smooth_chain_are_those_of_its_tessellation) {
  const Chain chain = cyclide_tube(test::crane_hook());
  const Tessellation mesh = tessellate(chain, kSampling, {0.05});
  const auto claim = mesh_claim(chain, kSampling, 0.05);
  ASSERT_TRUE(claim);
  EXPECT_EQ(claim->segments, 48U);
  EXPECT_EQ(claim->grid, 0x1p-16);
  EXPECT_EQ(claim->knots, mesh.knots);
  EXPECT_EQ(claim->error_bound, mesh.error_bound);
  EXPECT_TRUE(claim->inner_knots.empty());
  EXPECT_FALSE(claim->kneecaps);
}

TEST(MeshClaims, of_a_ball_have_no_knots) {
  const Sphere ball{Vec3(1, 2, 3), 4};
  const auto claim = mesh_claim(ball, kSampling, 0.05);
  ASSERT_TRUE(claim);
  EXPECT_TRUE(claim->knots.empty());
  EXPECT_EQ(claim->error_bound, tessellate(ball, kSampling).error_bound);
}

TEST(MeshClaims, of_a_hollow_chain_are_about_both_skins) {
  const Chain shell = cyclide_tube(test::jet_engine(), 0.08);
  auto claim = mesh_claim(shell, kSampling, 0.05);
  ASSERT_TRUE(claim);
  EXPECT_EQ(claim->inner_knots.front(), 0);
  EXPECT_EQ(claim->inner_knots.back(), 3);
  EXPECT_EQ(claim->error_bound, tessellate(shell, kSampling, {0.05}).error_bound);
  claim->error_bound *= 1.01;
  EXPECT_TRUE(follows(shell, *claim));
}

// Each piece takes milliseconds, and no certificate lets its checker work so long.
TEST(MeshClaims, of_thousands_of_curved_pieces_are_none) {
  std::vector<Waypoint> through;
  constexpr int kPieces = 2100;
  for (int i = 0; i < kPieces; ++i) {
    const double angle = 2 * std::numbers::pi * i / kPieces;
    through.push_back({4000 * Vec3(std::cos(angle), std::sin(angle), 0), 5});
  }
  Chain ring;
  for (RingedSurface& piece : closed_spline_pipe(through)) {
    ring.pieces.emplace_back(std::move(piece));
  }
  ring.closed = true;
  EXPECT_FALSE(mesh_claim(ring, kSampling, 0.05));
}

// How deep the triangles with corners on a joint's ball are, and the steps between rows of columns,
// as the mesh itself has them.
TEST(MeshClaims, of_kneecaps_are_what_the_mesh_has) {
  const Chain arm = kneecap_chain(test::lune_spheres());
  auto claim = mesh_claim(arm, kSampling, 0.05);
  ASSERT_TRUE(claim && claim->kneecaps);
  EXPECT_EQ(claim->segments, 47U) << "polygons with corners are not regular";
  EXPECT_EQ(claim->error_bound, tessellate(arm, kSampling, {0.05}).error_bound);
  EXPECT_GT(claim->kneecaps->turn, 0);
  EXPECT_LE(claim->kneecaps->turn, std::numbers::pi / 47);
  EXPECT_GE(claim->kneecaps->apart, 2 * std::sqrt(3) * 0x1p-16);
  ASSERT_EQ(claim->kneecaps->segments.size(), 1U);
  const Vec3 center(4, 1, 0);
  double deepest = 0;
  const TriMesh mesh = tessellate(arm, kSampling, {0.05}).mesh;
  for (const Triangle& t : mesh.triangles) {
    const bool is_on_ball = std::all_of(t.begin(), t.end(), [&](std::uint32_t corner) {
      return std::abs((mesh.points[corner] - center).norm() - 1) < 1e-4;
    });
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const Vec3 middle = (a + b + c) / 3 - center;
    // Those of discs look along the axis, not outwards.
    if (is_on_ball && (b - a).cross(c - a).normalized().dot(middle.normalized()) > .9) {
      deepest = std::max(deepest, 1 - middle.norm());
    }
  }
  const double claimed = 1 - std::cos(std::numbers::pi / claim->kneecaps->segments[0]);
  EXPECT_LE(deepest, claimed);
  EXPECT_GE(deepest, .25 * claimed);
  claim->error_bound *= 1.01;
  EXPECT_TRUE(follows(arm, *claim));
}

TEST(MeshClaims, of_kneecaps_of_two_skins_are_about_both) {
  Chain arm = hollow(kneecap_chain(test::lune_spheres()), .2);
  auto claim = mesh_claim(arm, kSampling, 0.05);
  ASSERT_TRUE(claim && claim->kneecaps);
  EXPECT_EQ(claim->kneecaps->segments.size(), 2U);
  EXPECT_EQ(claim->inner_knots.back(), 2);
  claim->error_bound *= 1.01;
  EXPECT_TRUE(follows(arm, *claim));
}

// Where the circles are one, there is no kneecap that might be too coarse.
TEST(MeshClaims, of_joints_without_kneecaps_have_as_many_segments_as_there_may_be) {
  const Chain straight = kneecap_chain(test::corner_spheres(0));
  const auto claim = mesh_claim(straight, kSampling, 0.05);
  ASSERT_TRUE(claim && claim->kneecaps);
  EXPECT_EQ(claim->kneecaps->segments, std::vector<std::uint32_t>{CertificateLimits::kSegments});
}

}  // namespace
}  // namespace dupin::certification
