#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/ringed/ringed_blends.h"
#include "surfaces/pieces/rational_piece_operations.h"

namespace dupin::surfaces {
namespace {

constexpr double kHeight = 4;

// Of horizontal circles.
RationalRingedTube oblique_cone() {
  return oblique_tube(Vec3(0, 0, 0), Vec3(2, 1, kHeight), Vec3::UnitZ(), 1, 1.5);
}

// From the circle of equal height.
double off_cone(const Vec3& x) {
  const double t = x.z() / kHeight;
  return std::hypot(x.x() - 2 * t, x.y() - t) - (1 + t / 2);
}

RationalRingedTube tube_of(const RationalRingedSurface& surface) {
  const MovingRing from = ring_at(surface, 0), to = ring_at(surface, 1);
  return {{from.center, -from.normal, from.radius}, {to.center, to.normal, to.radius}, surface};
}

RationalRingedSurface out_of_a_plate() {
  return ringed_blend(along_plate({Vec3(0, 0, 0), Vec3::UnitZ(), 2}, -3),
                      along_canal({Vec3(.5, 0, kHeight), Vec3::UnitZ(), 1}, 0, 4));
}

TEST(RationalPieceOperations, rows_of_an_oblique_cone_are_its_horizontal_circles) {
  const RationalRingedTube cone = oblique_cone();
  const RingSampling sampling{segments_for(cone, .01, 0), .3};
  const Tessellation found = surfaces::tessellate(cone, sampling, {.01});
  EXPECT_LE(found.error_bound, .01);
  ASSERT_EQ(found.knots.size(), found.bands + 1);
  for (std::size_t k = 0; k < found.mesh.points.size(); ++k) {
    const double t = found.knots[k / sampling.segments];
    EXPECT_NEAR(found.mesh.points[k].z(), ring_at(cone.surface, t).center.z(), 1e-13);
    EXPECT_NEAR(off_cone(found.mesh.points[k]), 0, 1e-13);
  }
  double largest = 0;
  for (const auto& [a, b, c] : found.mesh.triangles) {
    const Vec3 &p = found.mesh.points[a], &q = found.mesh.points[b], &r = found.mesh.points[c];
    for (const Vec3& x : {Vec3((p + q + r) / 3), Vec3((p + q) / 2), Vec3((p + r) / 2)}) {
      largest = std::max(largest, std::abs(off_cone(x)));
    }
  }
  EXPECT_LE(largest, found.error_bound);
  EXPECT_GE(largest, found.error_bound / 5);
}

// Of the discs, by samples: 1 - rho |n'| / d'.n.
TEST(RationalPieceOperations, margins_are_nearly_those_of_the_discs) {
  for (const RationalRingedSurface& surface :
       {test::cone_to_cylinder(), test::general_ends(),
        canal_ringed_blend(test::start_cone(), test::end_cone())}) {
    const RationalRingedTube tube = tube_of(surface);
    double least = 1;
    for (int i = 0; i <= 400; ++i) {
      const MovingRing ring = ring_at(surface, i / 400.);
      least = std::min(
          least, 1 - ring.radius * ring.normal_rate.norm() / ring.center_rate.dot(ring.normal));
    }
    const double margin = nearly_largest_margin(tube, 0);
    EXPECT_LT(margin, least);
    EXPECT_GT(margin, .8 * least);
    EXPECT_EQ(prove_margin(tube, 0, margin).verdict, Verdict::proved);
    EXPECT_EQ(prove_margin(tube, 0, least).verdict, Verdict::undecided);
    EXPECT_LE(margin_bounds(tube).lower, least);
  }
}

// At the plate nothing moves but the radius; what is steered has a margin there.
TEST(RationalPieceOperations, margins_are_proved_out_of_a_plate) {
  const RationalRingedTube tube = tube_of(out_of_a_plate());
  EXPECT_TRUE(margin_bounds(tube).regular);
  const double margin = nearly_largest_margin(tube, 0);
  EXPECT_GT(margin, 0);
  EXPECT_EQ(prove_margin(tube, 0, margin).verdict, Verdict::proved);
}

TEST(RationalPieceOperations, claims_no_tangency_but_how_the_discs_meet_the_rings) {
  for (const RationalRingedSurface& surface : {test::cone_to_cylinder(), out_of_a_plate()}) {
    const RationalRingedTube tube = tube_of(surface);
    for (const End end : {End::start, End::end}) {
      const TangencyClaim claim = tangency_claim(tube, end);
      EXPECT_FALSE(claim.deviation || claim.curvature || tangency(tube, end));
      EXPECT_LT(claim.axis_angle, 1e-7);
      EXPECT_LT(claim.offset, 1e-13);
    }
    EXPECT_EQ(extent(tube, 0).smallest, std::numeric_limits<double>::infinity());
  }
}

TEST(RationalPieceOperations, nurbs_have_a_quarter_of_the_circles_between_corners) {
  for (const RationalRingedTube& tube : {tube_of(test::general_ends()), oblique_cone()}) {
    const NurbsForm form = surfaces::nurbs(tube, .01);
    ASSERT_EQ(form.surfaces.size(), 1U);
    EXPECT_EQ(form.error_bound, 0);
    for (const double t : {0., .2, .5, 1.}) {
      for (int quarter = 0; quarter <= 4; ++quarter) {
        const double angle = quarter * std::numbers::pi / 2;
        EXPECT_LT((evaluate(form.surfaces[0], t, quarter / 4.) -
                   dupin::evaluate(tube.surface, t, angle).position)
                      .norm(),
                  1e-13);
      }
      // All round, and not only at the corners.
      const MovingRing ring = ring_at(tube.surface, t);
      for (int j = 0; j < 40; ++j) {
        EXPECT_NEAR((evaluate(form.surfaces[0], t, j / 40.) - ring.center).norm(), ring.radius,
                    1e-13);
      }
    }
  }
}

}  // namespace
}  // namespace dupin::surfaces
