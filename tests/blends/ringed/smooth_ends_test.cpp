#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/curvature_jump.h"
#include "dupin/blends/cyclic_blend.h"
#include "dupin/blends/regularity.h"
#include "dupin/blends/tangency.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/error.h"
#include "support/paper_surfaces.h"

namespace dupin {
namespace {

struct ContactRow {
  double from_slope, to_slope;
  Continuity continuity;
  std::size_t points;  // of the spine; 0 for the cubic
};

class SmoothEnds : public testing::TestWithParam<ContactRow> {};

TEST_P(SmoothEnds, take_the_least_degree_and_meet_their_neighbours) {
  const ContactRow row = GetParam();
  const Ring from{Vec3(0, 0, 0), Vec3::UnitX(), 1, row.from_slope};
  const Ring to{Vec3(14, 8, 3), -Vec3(1, 2, 3).normalized(), 1.5, row.to_slope};
  const RingedSurface blend = cyclic_blend(from, to, {.continuity = row.continuity});
  EXPECT_EQ(blend.start, flipped(from));
  EXPECT_EQ(blend.end, flipped(to));
  const BezierSpine* bezier = std::get_if<BezierSpine>(&blend.spine);
  EXPECT_EQ(bezier == nullptr ? 0 : bezier->points.size(), row.points);
  EXPECT_EQ(prove_margin(blend, .05).verdict, Verdict::proved);
  double jump = 0;
  for (const End end : {End::start, End::end}) {
    EXPECT_LT(tangency_at_end(blend, end).deviation.upper, 1e-13);
    jump = std::max(jump, curvature_jump_bound(blend, end));
  }
  if (row.continuity == Continuity::g2) {
    EXPECT_LT(jump, 1e-11);
  } else {
    EXPECT_GT(jump, 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Ends, SmoothEnds,
    testing::Values(ContactRow{0, 0, Continuity::g1, 0}, ContactRow{0, 0, Continuity::g2, 6},
                    ContactRow{.1, 0, Continuity::g1, 6}, ContactRow{.1, -.15, Continuity::g1, 6},
                    ContactRow{0, .05, Continuity::g2, 8}, ContactRow{.1, .1, Continuity::g2, 8}));

TEST(SmoothEnds, follow_the_cone_to_the_second_order) {
  const Ring from{Vec3(0, 0, 0), Vec3::UnitX(), 1, .2};
  const Ring to{Vec3(12, 6, 0), -Vec3::UnitY(), 1, 0};
  const auto deviation = [&](Continuity continuity, double t) {
    const RingedSurface blend =
        cyclic_blend(from, to, {.k = 12, .l = 12, .margin = 0, .continuity = continuity});
    const FrameField frames(blend.spine, Vec3::UnitY());
    double largest = 0;
    for (double u = 0; u < 6; u += .5) {
      const Vec3 x = evaluate(blend, frames, t, u).position;
      largest = std::max(largest, std::abs(std::hypot(x.y(), x.z()) - 1 - .2 * x.x()));
    }
    return largest;
  };
  // Halving t divides the distance from the cone by 4 for tangency and by 8 for equal curvature,
  // or more.
  EXPECT_GT(deviation(Continuity::g1, .02) / deviation(Continuity::g1, .01), 3.8);
  EXPECT_GT(deviation(Continuity::g2, .02) / deviation(Continuity::g2, .01), 7.6);
}

TEST(SmoothEnds, can_be_tessellated) {
  const Ring from{Vec3(0, 0, 0), Vec3::UnitX(), 1, .1};
  const Ring to{Vec3(12, 6, 2), -Vec3::UnitY(), 1.5, 0};
  const Tessellation result =
      tessellate(cyclic_blend(from, to), {.segments = 48}, {.tolerance = .05});
  EXPECT_GT(result.mesh.triangles.size(), 1000u);
  EXPECT_LE(result.error_bound, .05);
}

std::string message_of(const Ring& from, const Ring& to, const CyclicBlendOptions& options) {
  try {
    (void)cyclic_blend(from, to, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(SmoothEnds, refuse_a_cone_too_steep_for_the_speed_and_the_second_law) {
  const Ring from{Vec3(0, 0, 0), Vec3::UnitX(), 1, -.5}, to{Vec3(12, 6, 0), -Vec3::UnitY(), 1};
  EXPECT_NE(message_of(from, to, {.k = 12, .l = 8}).find("stay positive"), std::string::npos);
  EXPECT_NE(message_of(from, to, {.radius_law = BlendLaw::r2}).find("take R1"), std::string::npos);
}

TEST(CurvatureJump, of_a_cubic_blend_is_its_spines_curvature_and_the_radius_laws) {
  // At theta = pi the normal curvature is (R'' / (v q)) + kappa v / q with q = v (1 + kappa R); the
  // bound looks at both signs apart, so it may exceed it by the width of q's range.
  const RingedSurface surface = test::figure6();
  const double kappa = curvature(evaluate(surface.spine, 0)), v = 10, rise = 6;
  const double largest = kappa / (1 - kappa) + rise / (v * v * (1 - kappa) * (1 - kappa));
  const double bound = curvature_jump_bound(surface, End::start);
  EXPECT_GE(bound, kappa / (1 - kappa) - rise / (v * v * (1 - kappa) * (1 - kappa)));
  EXPECT_LE(bound, largest * std::pow((1 + kappa) / (1 - kappa), 3));
}

TEST(CurvatureJump, refuses_an_end_that_folds) {
  RingedSurface surface = test::figure6();
  surface.radius = ConstantRadius{3};  // 1 - kappa R < 0 at the start
  EXPECT_THROW((void)curvature_jump_bound(surface, End::start), Error);
}

}  // namespace
}  // namespace dupin
