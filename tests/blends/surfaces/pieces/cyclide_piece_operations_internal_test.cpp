#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"
#include "surfaces/pieces/cyclide_piece_operations.h"

namespace dupin::surfaces {
namespace {

std::vector<CyclidePiece> pieces_of(const CyclideChain& chain) {
  std::vector<CyclidePiece> result;
  for (const PeArc& arc : chain.pieces) {
    result.push_back(cyclide_piece(arc));
  }
  return result;
}

double off_surface(const CyclideChain& chain, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const PeArc& arc : chain.pieces) {
    least = std::min(least, signed_distance(arc, point));
  }
  return std::abs(least);
}

// Pieces that meet smoothly, in planes that turn.
TEST(CyclidePieceOperations, a_run_is_swept_as_one_tube) {
  const CyclideChain chain = test::twisted_crane_hook();
  const std::vector<CyclidePiece> run = pieces_of(chain);
  constexpr double kTolerance = .02;
  const RingSampling sampling{segments_for(run, kTolerance, 0), .3};
  const Tessellation found = surfaces::tessellate(run, sampling, {kTolerance});
  const Report report = check(found.mesh);
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.euler_number, 0);
  EXPECT_EQ(report.count(Defect::boundary_edge), 2 * sampling.segments);
  EXPECT_EQ(report.count(Defect::inconsistent_orientation), 0U);
  EXPECT_EQ(report.count(Defect::self_intersection), 0U);
  // Every row is a circle of its piece, the joints among them.
  ASSERT_EQ(found.knots.size(), found.bands + 1);
  for (std::size_t i = 0; i <= run.size(); ++i) {
    EXPECT_TRUE(std::binary_search(found.knots.begin(), found.knots.end(), double(i))) << i;
  }
  for (std::size_t k = 0; k < found.mesh.points.size(); ++k) {
    const double knot = found.knots[k / sampling.segments];
    const auto piece = std::min(std::size_t(knot), run.size() - 1);
    const Ring circle = circle_at(chain.pieces[piece], knot - double(piece));
    EXPECT_NEAR((found.mesh.points[k] - circle.center).norm(), circle.radius, 1e-12);
    EXPECT_NEAR((found.mesh.points[k] - circle.center).dot(circle.normal), 0, 1e-12);
  }
  double largest = 0;
  for (std::size_t i = 0; i < found.mesh.triangles.size(); i += 3) {
    const auto& [a, b, c] = found.mesh.triangles[i];
    const Vec3 middle = (found.mesh.points[a] + found.mesh.points[b] + found.mesh.points[c]) / 3;
    largest = std::max(largest, off_surface(chain, middle));
  }
  EXPECT_LE(found.error_bound, kTolerance);
  EXPECT_LE(largest, found.error_bound);
  EXPECT_GE(largest, found.error_bound / 4);
}

TEST(CyclidePieceOperations, a_run_needs_the_segments_of_its_widest_piece) {
  const std::vector<CyclidePiece> run = pieces_of(test::jet_engine());
  std::uint32_t most = 0;
  for (const CyclidePiece& piece : run) {
    most = std::max(most, segments_for(piece, .01, 0));
  }
  EXPECT_EQ(segments_for(run, .01, 0), most);
  EXPECT_THROW((void)segments_for(run, .01, .01), Error) << "the grid takes all of the tolerance";
}

// 1 - R |n'| / (c'.n) of the least favourable circle, by central differences.
double sampled_margin(const PeArc& arc) {
  double least = 1;
  const double h = 1e-5;
  for (int i = 1; i < 200; ++i) {
    const double t = i / 200.;
    const Ring before = circle_at(arc, t - h), here = circle_at(arc, t),
               after = circle_at(arc, t + h);
    least = std::min(least, 1 - here.radius * (after.normal - before.normal).norm() /
                                    (after.center - before.center).dot(here.normal));
  }
  return least;
}

TEST(CyclidePieceOperations, margins_hold_for_the_discs_of_both_skins) {
  constexpr double kWall = .4;
  test::RandomArcs arcs;
  int proved = 0, too_thick = 0;
  for (int i = 0; i < 30; ++i) {
    const PeArc arc = arcs.next();
    const CyclidePiece piece = cyclide_piece(arc);
    EXPECT_TRUE(margin_bounds(piece).regular);
    EXPECT_LT(nearly_largest_margin(piece, 0), sampled_margin(arc) + 1e-6);
    const double margin = nearly_largest_margin(piece, kWall);
    if (least_radius(arc) < kWall) {
      EXPECT_EQ(margin, 0);
      EXPECT_EQ(prove_margin(piece, kWall, 0).verdict, Verdict::undecided);
      ++too_thick;
    } else if (margin > 0) {
      const double least = std::min(sampled_margin(arc), sampled_margin(offset(arc, -kWall)));
      EXPECT_LT(margin, least + 1e-6);
      EXPECT_EQ(prove_margin(piece, kWall, margin).verdict, Verdict::proved);
      EXPECT_EQ(prove_margin(piece, kWall, least + 1e-3).verdict, Verdict::undecided);
      ++proved;
    }
  }
  EXPECT_GT(proved, 5);
  EXPECT_GT(too_thick, 5);
}

// A quarter of a torus about the z axis.
CyclidePiece torus_quarter() {
  return cyclide_piece(PeArc::from(test::sphere(3, 0, 0, 1), test::direction(Vec3::UnitY(), 0),
                                   test::sphere(0, 3, 0, 1)));
}

TEST(CyclidePieceOperations, of_a_torus_have_closed_forms) {
  const CyclidePiece piece = torus_quarter();
  EXPECT_NEAR(extent(piece, .25).smallest, .75, 1e-12);
  EXPECT_NEAR(extent(piece, .25).largest, 4, 1e-12);
  const MarginBounds bounds = margin_bounds(piece);
  EXPECT_LE(bounds.lower, 2. / 3);
  EXPECT_GE(bounds.upper.value(), 2. / 3);
  EXPECT_NEAR(bounds.lower, bounds.upper.value(), 1e-12);
  EXPECT_NEAR(nearly_largest_margin(piece, .25), 2. / 3, .05);
}

TEST(CyclidePieceOperations, claims_the_angle_to_the_cone_beyond) {
  test::RandomArcs arcs;
  for (int i = 0; i < 30; ++i) {
    const CyclidePiece piece = cyclide_piece(arcs.next());
    for (const End end : {End::start, End::end}) {
      const TangencyClaim claim = tangency_claim(piece, end);
      EXPECT_LT(claim.deviation.value(), 1e-12);
      EXPECT_LT(claim.axis_angle, 1e-7);  // an angle of nearly parallel vectors has half the digits
      EXPECT_LT(claim.offset, 1e-11);
    }
  }
  for (const double slope : {0., .25, -.25}) {
    CyclidePiece piece = torus_quarter();
    piece.start.slope = piece.end.slope = slope;
    for (const End end : {End::start, End::end}) {
      const double angle = tangency_claim(piece, end).deviation.value();
      EXPECT_NEAR(angle, std::atan(std::abs(slope)), 1e-14);
      EXPECT_GE(angle, std::atan(std::abs(slope)) * (1 - 1e-15));
      EXPECT_GE(tangency(piece, end).value(), angle - 1e-15);
      EXPECT_LE(tangency(piece, end).value(), std::abs(slope) + 1e-14);  // the angle's tangent
    }
  }
}

TEST(CyclidePieceOperations, nurbs_are_patches_that_cover_the_piece) {
  test::RandomArcs arcs;
  for (int i = 0; i < 5; ++i) {
    const PeArc arc = arcs.next();
    const NurbsForm form = surfaces::nurbs(cyclide_piece(arc), .01);
    EXPECT_EQ(form.error_bound, 0);
    double covered = 0;
    for (const NurbsSurface& surface : form.surfaces) {
      constexpr int kSteps = 24;
      const auto at = [&](int a, int b) {
        return evaluate(surface, double(a) / kSteps, double(b) / kSteps);
      };
      for (int a = 0; a < kSteps; ++a) {
        for (int b = 0; b < kSteps; ++b) {
          EXPECT_NEAR(signed_distance(arc, at(a, b)), 0, 1e-10);
          covered += (at(a + 1, b + 1) - at(a, b)).cross(at(a, b + 1) - at(a + 1, b)).norm() / 2;
        }
      }
    }
    EXPECT_NEAR(covered, area(arc), .005 * area(arc));
  }
}

}  // namespace
}  // namespace dupin::surfaces
