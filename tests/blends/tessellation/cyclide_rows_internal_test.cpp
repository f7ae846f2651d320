#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
#include "support/cyclide_cases.h"
#include "tessellation/cyclide_rows.h"

namespace dupin::tessellation {
namespace {

using std::numbers::pi;

TEST(CyclideRows, are_the_circles_at_equal_tangential_lengths) {
  test::RandomArcs arcs;
  for (int i = 0; i < 30; ++i) {
    const PeArc arc = arcs.next();
    const Vec3 plane_normal = frame(arc).second;
    for (const double fraction : {0.25, 0.5, 0.75}) {
      const Row row = row_at(arc, fraction, plane_normal);
      // On the surface, all round.
      for (double u = 0; u < 6; u += 0.7) {
        const Vec3 point = row.center + row.scale * row.direction(u);
        EXPECT_NEAR(signed_distance(arc, point), 0, 1e-11);
      }
      // With a right-handed frame about the direction of travel.
      EXPECT_NEAR(row.first.norm(), 1, 1e-14);
      EXPECT_EQ(row.second, plane_normal);
      const double h = 1e-3;
      const Vec3 ahead = row_at(arc, fraction + h, plane_normal).center - row.center;
      EXPECT_GT(row.first.cross(row.second).dot(ahead.normalized()), 0.1);
    }
    // The row after three tenths of the length is the end of the part of that length.
    const PeArc part = sub_arc(arc, 0, cyclide::parameter_at(arc, 0.3));
    EXPECT_NEAR(pe_length(part), 0.3 * pe_length(arc), 1e-9 * pe_length(arc));
    EXPECT_LT((row_at(part, 1, plane_normal).center - row_at(arc, 0.3, plane_normal).center).norm(),
              1e-9);
  }
}

// The mesh of the rows that the march asks for, measured at its triangles.
TEST(CyclideRows, keep_the_bound_that_the_march_states) {
  constexpr std::uint32_t kSegments = 24;
  constexpr double kAround = 2 * pi / kSegments;
  test::RandomArcs arcs;
  double most = 0;
  for (int i = 0; i < 20; ++i) {
    const PeArc arc = arcs.next();
    const BandStepper march = march_of(arc, kAround);
    const Bands bands = even_bands({march}, 0.02, largest_circle(arc), kSegments).front();
    const Vec3 plane_normal = frame(arc).second;
    TriMesh mesh;
    double largest = 0;
    for (std::size_t j = 0; j < bands.knots.size(); ++j) {
      const Row row = row_at(arc, bands.knots[j], plane_normal);
      for (std::uint32_t k = 0; k < kSegments; ++k) {
        mesh.points.push_back(row.center + row.scale * row.direction(kAround * k));
      }
      if (j > 0) {
        append_band(mesh, kSegments);
      }
    }
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3 &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
      for (const Vec3& x : {Vec3((p + q + r) / 3), Vec3((p + q) / 2), Vec3((q + r) / 2)}) {
        largest = std::max(largest, std::abs(signed_distance(arc, x)));
      }
    }
    EXPECT_LE(largest, bands.error_bound) << i;
    most = std::max(most, largest / bands.error_bound);
  }
  EXPECT_GT(most, 0.5) << "the bound would be useless";
}

TEST(CyclideRows, know_the_largest_circle_nearly) {
  test::RandomArcs arcs;
  for (int i = 0; i < 30; ++i) {
    const PeArc arc = arcs.next();
    double largest = 0;
    for (int k = 0; k <= 4000; ++k) {
      largest = std::max(largest, circle_at(arc, k / 4000.).radius);
    }
    EXPECT_NEAR(largest_circle(arc), largest, 0.01 * largest) << i;
  }
}

// Far out, where rounding counts, and on a grid. Points of a circle are on its sphere.
TEST(CyclideRows, have_points_as_near_as_the_error_says) {
  test::RandomArcs arcs;
  for (const auto& [scale, grid] : {std::pair(1e6, 0.), {1., 0x1p-8}}) {
    double most = 0;
    for (int i = 0; i < 30; ++i) {
      const PeArc near = arcs.next();
      const Vec3 shift = scale * Vec3(1, -1, 0.5);
      const PeArc arc = PeArc::from({near.start().m + shift, near.start().r}, near.start_tangent(),
                                    {near.end().m + shift, near.end().r});
      const double bound = point_error(arc, grid);
      for (const double fraction : {0., 0.3, 0.5, 1.}) {
        const Row row = row_at(arc, fraction, frame(arc).second);
        const PeVector sphere = sphere_at(near, cyclide::parameter_at(arc, fraction));
        for (double u = 0; u < 6; u += 0.3) {
          const Vec3 point = snapped(row.center + row.scale * row.direction(u), grid);
          const double off = std::abs((point - shift - sphere.m).norm() - sphere.r);
          EXPECT_LE(off, bound);
          most = std::max(most, off / bound);
        }
      }
    }
    EXPECT_GT(most, 0.001) << "the bound would be useless";
  }
}

}  // namespace
}  // namespace dupin::tessellation
