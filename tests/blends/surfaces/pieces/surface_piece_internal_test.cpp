#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/nurbs.h"
#include "dupin/blends/tessellate.h"
#include "support/cyclide_cases.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin {
namespace {

// What has to hold of a piece of any kind.

template <class Kind>
Kind sample_piece();

const Ring kFrom{Vec3(0, 0, 0), -Vec3::UnitZ(), 1}, kTo{Vec3(3, 0, 4), Vec3::UnitX(), 1.2};

template <>
RingedSurface sample_piece() {
  return cyclic_blend(flipped(kFrom), flipped(kTo));
}

template <>
EllipticTube sample_piece() {
  const Ring oval{kTo.center, kTo.normal, 1.2, 0, Ellipse{Vec3::UnitY(), 0.8, 0}};
  return elliptic_blend(flipped(kFrom), flipped(oval));
}

template <>
CyclidePiece sample_piece() {
  return cyclide_piece(test::crane_hook().pieces[1]);
}

template <>
RationalRingedTube sample_piece() {
  return oblique_tube(Vec3(0, 0, 0), Vec3(1, 0, 4), Vec3::UnitZ(), 1, 1.5);
}

template <class Kind>
class APiece : public testing::Test {
 protected:
  const Kind piece_ = sample_piece<Kind>();
};

template <class>
struct Kinds;
template <class... All>
struct Kinds<std::variant<All...>> {
  using Types = testing::Types<All...>;
};
TYPED_TEST_SUITE(APiece, Kinds<Piece>::Types);

TYPED_TEST(APiece, is_meshed_between_the_polygons_of_its_rings) {
  constexpr double kTolerance = 0.01;
  const RingSampling sampling{surfaces::segments_for(this->piece_, kTolerance, 0), 0.3,
                              std::ldexp(1.0, -30)};
  const Tessellation result = surfaces::tessellate(this->piece_, sampling, {kTolerance});
  EXPECT_LE(result.error_bound, kTolerance);
  EXPECT_EQ(result.mesh.points.size(), (result.bands + 1) * sampling.segments);
  const auto first = sample(flipped(end_ring(this->piece_, End::start)), sampling);
  EXPECT_TRUE(std::equal(first.begin(), first.end(), result.mesh.points.begin()));
  const auto last = sample(end_ring(this->piece_, End::end), sampling);
  EXPECT_TRUE(std::is_permutation(last.begin(), last.end(),
                                  result.mesh.points.end() - std::ptrdiff_t(sampling.segments)));
}

TYPED_TEST(APiece, alone_is_a_chain_with_the_same_mesh) {
  const Chain chain = this->piece_;
  const RingSampling sampling{segments_for(chain, 0.02)};
  EXPECT_EQ(sampling.segments, surfaces::segments_for(this->piece_, 0.02, 0));
  const TriMesh own = surfaces::tessellate(this->piece_, sampling, {0.02}).mesh;
  const TriMesh of_chain = tessellate(chain, sampling, {0.02}).mesh;
  EXPECT_EQ(own.points, of_chain.points);
  EXPECT_EQ(own.triangles, of_chain.triangles);
  EXPECT_EQ(nurbs(PartSurface(chain), 0.02).surfaces.size(),
            surfaces::nurbs(this->piece_, 0.02).surfaces.size());
}

TYPED_TEST(APiece, has_discs_that_advance_from_ring_to_ring) {
  const surfaces::PieceDiscs discs = surfaces::discs(this->piece_);
  for (const End end : {End::start, End::end}) {
    const double t = end == End::start ? 0 : 1;
    const surfaces::DiscHull hull = discs.hull({t, t});
    const Ring& ring = end_ring(this->piece_, end);
    EXPECT_LT((hull.middle() - ring.center).norm(), 1e-12);
    EXPECT_LE(hull.radius.lower, ring.radius + 1e-12);
    EXPECT_GE(hull.radius.upper, ring.radius - 1e-12);
    // The disc has no extent along its own normal; bounds by way of a cosine have half the digits.
    const double beyond = surfaces::support(hull, ring.normal) - ring.normal.dot(ring.center);
    EXPECT_GE(beyond, -1e-12);
    EXPECT_LT(beyond, 1e-6);
  }
  const auto pace = discs.pace({0.5, 0.5 + 0x1p-10});
  ASSERT_TRUE(pace.has_value());
  EXPECT_GT(pace->advance, 0);
}

TYPED_TEST(APiece, keeps_the_margin_that_is_nearly_its_largest) {
  const double margin = surfaces::nearly_largest_margin(this->piece_, 0);
  EXPECT_GT(margin, 0);
  const surfaces::ProvedStretches proof = surfaces::prove_margin(this->piece_, 0, margin);
  ASSERT_EQ(proof.verdict, Verdict::proved);
  EXPECT_EQ(proof.leaves.front().from, 0);
  EXPECT_EQ(proof.leaves.back().to, 1);
  EXPECT_NE(surfaces::prove_margin(this->piece_, 0, 1).verdict, Verdict::proved);
  const surfaces::MarginBounds bounds = surfaces::margin_bounds(this->piece_);
  EXPECT_TRUE(bounds.regular);
  EXPECT_NEAR(bounds.lower, margin, 0.05);
  EXPECT_GE(bounds.upper.value_or(1), margin);
}

TYPED_TEST(APiece, meets_its_rings) {
  for (const End end : {End::start, End::end}) {
    const Ring& ring = end_ring(this->piece_, end);
    const TangencyClaim claim = surfaces::tangency_claim(this->piece_, end);
    EXPECT_LT(claim.axis_angle, 1e-7);
    EXPECT_LT(claim.offset, 1e-12);
    const MovingRing motion = surfaces::leaving(this->piece_, end);
    EXPECT_EQ(motion.center, ring.center);
    EXPECT_EQ(motion.normal, ring.normal);
    EXPECT_GT(motion.center_rate.dot(ring.normal), 0);
  }
}

TYPED_TEST(APiece, off_its_ring_is_told) {
  auto moved = this->piece_;
  moved.end.radius += 0.01;
  EXPECT_NEAR(surfaces::tangency_claim(moved, End::end).offset, 0.01, 1e-12);
  moved.end.center += 0.02 * moved.end.normal;
  EXPECT_NEAR(surfaces::tangency_claim(moved, End::end).offset, 0.03, 1e-12);
  constexpr double kTilt = 0.01;
  for (Ring* ring : {&moved.start, &moved.end}) {
    ring->normal = Eigen::AngleAxisd(kTilt, reference_axis(*ring)) * ring->normal;
  }
  for (const End end : {End::start, End::end}) {
    const double angle = surfaces::tangency_claim(moved, end).axis_angle;
    EXPECT_NEAR(angle, kTilt, 1e-7);
    EXPECT_GE(angle, kTilt - 1e-12);
  }
}

}  // namespace
}  // namespace dupin
