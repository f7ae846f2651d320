#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/tangency.h"
#include "support/paper_surfaces.h"
#include "surfaces/pieces/ringed_piece_operations.h"

namespace dupin::surfaces {
namespace {

using std::numbers::pi;

constexpr double kBend = 4;

// From the x axis about the z axis.
RingedSurface elbow(double radius, double angle) {
  const Vec3 out(std::cos(angle), std::sin(angle), 0);
  return {{Vec3(kBend, 0, 0), -Vec3::UnitY(), radius},
          {kBend * out, Vec3::UnitZ().cross(out), radius},
          ArcSpine{Vec3(0, 0, 0), Vec3::UnitZ(), Vec3(kBend, 0, 0), angle},
          ConstantRadius{radius}};
}

RingedSurface straight(const RadiusLaw& radius, double end_slope) {
  return {{Vec3(0, 0, 0), -Vec3::UnitX(), evaluate(radius, 0).value},
          {Vec3(4, 0, 0), Vec3::UnitX(), evaluate(radius, 1).value, end_slope},
          LineSpine{Vec3(0, 0, 0), Vec3(4, 0, 0)},
          radius};
}

TEST(RingedPieceOperations, bands_of_an_elbow_are_equally_long_and_turn_with_it) {
  constexpr double kAngle = 5;
  const RingedSurface surface = elbow(1, kAngle);
  const RingSampling sampling{24, 0.3, 0};
  const Tessellation found = surfaces::tessellate(surface, sampling, {0.02});
  ASSERT_GT(found.bands, 8U);
  // The angle of a point in its circle, turned back to the start.
  const auto angle = [&](std::uint32_t row, std::uint32_t column) {
    const Eigen::AngleAxisd back(-kAngle * found.knots[row], Vec3::UnitZ());
    const Vec3 d = back * found.mesh.points[std::size_t{24} * row + column] - surface.start.center;
    EXPECT_NEAR(std::hypot(d.x(), d.z()), 1, 1e-14);
    EXPECT_NEAR(d.y(), 0, 1e-14);
    return std::atan2(-d.z(), d.x());
  };
  // What is missing to the end's polygon, at most half a segment, is spread over the rows.
  const double twist = std::remainder(angle(found.bands, 0) - angle(0, 0), 2 * pi);
  EXPECT_LE(std::abs(twist), pi / 24 + 1e-12);
  for (std::uint32_t row = 0; row <= found.bands; ++row) {
    const double share = double(row) / found.bands;
    EXPECT_NEAR(found.knots[row], share, 2e-3);
    for (std::uint32_t column = 0; column < 24; ++column) {
      const double turned = angle(row, column) - angle(0, column) - twist * share;
      EXPECT_NEAR(std::remainder(turned, 2 * pi), 0, 1e-12);
    }
  }
}

// Against the double reflection, which is more accurate.
TEST(RingedPieceOperations, rows_of_a_skew_spine_turn_no_more_than_it_forces_them_to) {
  const RingedSurface surface = test::figure6();
  const RingSampling sampling{16, 0.3, 0};
  const Tessellation found = surfaces::tessellate(surface, sampling, {0.02});
  const FrameField frames(surface.spine, found.mesh.points[0] - surface.start.center,
                          {.knots = 4096});
  const auto angle = [&](std::uint32_t row) {
    const Vec3 d = found.mesh.points[std::size_t{16} * row] -
                   evaluate(surface.spine, found.knots[row]).position;
    const Frame frame = frames.at(found.knots[row]);
    return std::atan2(d.dot(frame.second), d.dot(frame.first));
  };
  const double twist = angle(found.bands);
  EXPECT_LE(std::abs(twist), pi / 16 + 1e-3);
  for (std::uint32_t row = 0; row <= found.bands; ++row) {
    EXPECT_NEAR(angle(row), twist * row / found.bands, 1e-3);
  }
}

TEST(RingedPieceOperations, margin_of_an_elbow_is_that_of_the_torus) {
  for (const double radius : {1., 3.}) {
    const RingedSurface surface = elbow(radius, 2);
    const double margin = 1 - radius / kBend;
    const MarginBounds bounds = margin_bounds(surface);
    EXPECT_LE(bounds.lower, margin);
    EXPECT_GE(bounds.upper.value(), margin);
    EXPECT_NEAR(bounds.lower, bounds.upper.value(), 1e-6);
    EXPECT_EQ(prove_margin(surface, 0, margin - 1e-6).verdict, Verdict::proved);
    EXPECT_EQ(prove_margin(surface, 0, margin + 1e-6).verdict, Verdict::refuted);
    EXPECT_NEAR(nearly_largest_margin(surface, 0), margin, 1e-3);
  }
  EXPECT_FALSE(margin_bounds(elbow(5, 2)).regular);
}

TEST(RingedPieceOperations, claims_the_angle_to_the_cone_beyond) {
  struct Row {
    RadiusLaw radius;
    double slope, angle;
  };
  const Row rows[] = {
      {ConstantRadius{1}, 0, 0},
      {ConstantRadius{1}, .25, std::atan(.25)},
      {LinearRadius{1, 2}, .25, 0},
      {LinearRadius{1, 2}, 0, std::atan(.25)},
      {LinearRadius{2, 1}, .25, 2 * std::atan(.25)},
      {CubicRadius{1, 2}, 0, 0},
  };
  for (const Row& row : rows) {
    const RingedSurface surface = straight(row.radius, row.slope);
    const TangencyClaim claim = tangency_claim(surface, End::end);
    EXPECT_NEAR(claim.deviation.value(), row.angle, 1e-14);
    EXPECT_GE(claim.deviation.value(), row.angle * (1 - 1e-15));
    EXPECT_EQ(claim.deviation, tangency(surface, End::end));
    EXPECT_EQ(claim.axis_angle, 0);
  }
}

// An elbow's inside is bent most. A checker rounds on its own.
TEST(RingedPieceOperations, claims_the_curvature_that_it_ends_with) {
  for (const double radius : {1., 3.}) {
    for (const End end : {End::start, End::end}) {
      const double curvature = tangency_claim(elbow(radius, 2), end).curvature.value(),
                   bound = curvature_jump_bound(elbow(radius, 2), end);
      EXPECT_GE(curvature, 1 / (kBend - radius));
      EXPECT_GT(curvature, bound);
      EXPECT_LT(curvature, bound * (1 + 1e-5));
    }
  }
  EXPECT_EQ(tangency_claim(straight(LinearRadius{1, 2}, .25), End::end).curvature, 0);
  EXPECT_FALSE(tangency_claim(elbow(5, 2), End::end).curvature.has_value()) << "has folded";
}

TEST(RingedPieceOperations, lengths_matter_to_the_lattice) {
  EXPECT_EQ(extent(straight(CubicRadius{1, 2}, 0), 0).smallest, 4);
  const auto torus = [](double angle) {
    return extent(
        RingedSurface{
            {}, {}, ArcSpine{Vec3::Zero(), Vec3::UnitZ(), Vec3(4, 0, 0), angle}, ConstantRadius{1}},
        0);
  };
  const double turn = 2 * std::numbers::pi;
  EXPECT_EQ(torus(2).smallest, 8);
  EXPECT_EQ(torus(2).clearance, 3);
  EXPECT_EQ(torus(1e-6).smallest, 4e-6);
  EXPECT_DOUBLE_EQ(torus(1e-6).clearance, 3e-6);
  EXPECT_NEAR(torus(turn - 1e-6).clearance, 3e-6, 1e-14) << "between its ends";
}

TEST(RingedPieceOperations, nurbs_are_exact_or_lofted) {
  const NurbsForm exact = surfaces::nurbs(elbow(1, 2), .01);
  EXPECT_EQ(exact.error_bound, 0);
  EXPECT_EQ(exact.surfaces.front().degree_along, 2);
  const NurbsForm lofted = surfaces::nurbs(test::figure6(), .01);
  EXPECT_GT(lofted.error_bound, 0);
  EXPECT_LE(lofted.error_bound, .01);
  EXPECT_EQ(lofted.surfaces.front().degree_along, 3);
}

TEST(RingedPieceOperations, a_torus_that_keeps_off_its_axis_is_embedded) {
  const auto torus = [](double radius, double angle, double bend = 1) {
    return is_embedded_torus({{Vec3(bend, 0, 0), Vec3(0, -1, 0), radius},
                              {Vec3(bend, 0, 0), Vec3(0, 1, 0), radius},
                              ArcSpine{Vec3::Zero(), Vec3::UnitZ(), Vec3(bend, 0, 0), angle},
                              ConstantRadius{radius}});
  };
  EXPECT_TRUE(torus(0.5, 6.28));
  EXPECT_TRUE(torus(std::nextafter(1.0, 0.0), 1));
  EXPECT_FALSE(torus(1, 1));
  EXPECT_FALSE(torus(std::nextafter(1.0, 2.0), 1));
  EXPECT_FALSE(torus(0.5, 6.29)) << "it comes back to itself";
  for (const double none : {std::nan(""), HUGE_VAL}) {
    EXPECT_FALSE(torus(none, 1) || torus(0.5, none) || torus(0.5, 1, none));
  }
}

}  // namespace
}  // namespace dupin::surfaces
