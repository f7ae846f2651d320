#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/check.h"
#include "support/cyclide_cases.h"
#include "tessellation/kneecap_mesh.h"

namespace dupin::tessellation {
namespace {

using Indices = std::vector<std::uint32_t>;

struct Kneecap {
  JointCircles joint;
  TriMesh mesh;
  Indices before, after;
  double error = 0;
  double exposed_area = 0;  ///< of the smooth one
};

Indices added(TriMesh& mesh, const std::vector<Vec3>& points) {
  Indices result(points.size());
  std::iota(result.begin(), result.end(), std::uint32_t(mesh.points.size()));
  mesh.points.insert(mesh.points.end(), points.begin(), points.end());
  return result;
}

// Between polygons as fine as the tolerance asks of circles of radius 1.
Kneecap kneecap(const std::vector<PeVector>& spheres, double allowed, double grid) {
  const std::vector<PeArc> pieces = through_all(spheres);
  Kneecap result;
  result.joint = joint(pieces.at(0), pieces.at(1), 0, grid);
  result.exposed_area = spherical_joint(pieces[0], pieces[1]).exposed_area;
  const auto segments = std::uint32_t(std::ceil(2 * std::numbers::pi / std::sqrt(2 * allowed))) + 1;
  const auto edge = [&](const Ring& circle) {
    const JointPolygon polygon = joint_polygon(result.joint, circle, segments, grid);
    const bool is_lune = result.joint.kind == JointKind::lune;
    return std::vector<Vec3>(polygon.points.begin(),
                             polygon.points.begin() + polygon.exposed + (is_lune ? 1 : 0));
  };
  const std::vector<Vec3> before = edge(result.joint.before);
  std::vector<Vec3> after = edge(result.joint.after);
  result.before = added(result.mesh, before);
  if (result.joint.kind == JointKind::lune) {
    EXPECT_EQ(after.front(), before.front());
    EXPECT_EQ(after.back(), before.back());
    after = {after.begin() + 1, after.end() - 1};
  }
  result.after = added(result.mesh, after);
  if (result.joint.kind == JointKind::lune) {
    result.after.insert(result.after.begin(), result.before.front());
    result.after.push_back(result.before.back());
  }
  result.error = append_kneecap(result.mesh, result.joint, result.before, result.after,
                                {segments, allowed, grid});
  return result;
}

std::vector<std::vector<PeVector>> joints() {
  return {test::lune_spheres(),
          test::corner_spheres(0.3),
          test::corner_spheres(2),
          test::cylinder_to_cone_spheres(-0.2, 1),
          test::cylinder_to_cone_spheres(-0.2, 0),
          test::cylinder_to_cone_spheres(-0.2, 0.15)};
}

TEST(KneecapMesh, is_no_further_from_the_sphere_than_it_says) {
  constexpr double kAllowed = 0.01, kGrid = 0x1p-24;
  for (const auto& spheres : joints()) {
    const Kneecap found = kneecap(spheres, kAllowed, kGrid);
    const auto& [m, r] = found.joint.sphere;
    EXPECT_LE(found.error, kAllowed);
    for (const Vec3& point : found.mesh.points) {
      EXPECT_NEAR((point - m).norm(), r, kGrid);
    }
    double largest = 0;
    constexpr int kSteps = 12;
    for (const auto& [a, b, c] : found.mesh.triangles) {
      for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; i + j <= kSteps; ++j) {
          const Vec3 x = (i * found.mesh.points[a] + j * found.mesh.points[b] +
                          (kSteps - i - j) * found.mesh.points[c]) /
                         kSteps;
          largest = std::max(largest, std::abs((x - m).norm() - r));
        }
      }
    }
    EXPECT_LE(largest, found.error + 2 * kGrid);
    EXPECT_GE(largest, 0.9 * found.error);
  }
}

TEST(KneecapMesh, is_a_disc_or_a_band_between_both_edges) {
  for (const auto& spheres : joints()) {
    const Kneecap found = kneecap(spheres, 0.01, 0x1p-24);
    const bool is_lune = found.joint.kind == JointKind::lune;
    const Report report = check(found.mesh);
    EXPECT_EQ(report.components, 1U);
    EXPECT_EQ(report.euler_number, is_lune ? 1 : 0);
    for (const Defect none :
         {Defect::non_manifold_edge, Defect::non_manifold_vertex, Defect::inconsistent_orientation,
          Defect::self_intersection, Defect::degenerate_face, Defect::isolated_point}) {
      EXPECT_EQ(report.count(none), 0U) << name(none);
    }
    const auto steps = [&](const Indices& edge) { return edge.size() - (is_lune ? 1 : 0); };
    EXPECT_EQ(report.count(Defect::boundary_edge), steps(found.before) + steps(found.after));
    // On the left of the edge before, on the right of that after, and out of the ball.
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& [a, b, c] : found.mesh.triangles) {
      ++edges[{a, b}];
      ++edges[{b, c}];
      ++edges[{c, a}];
      const Vec3 &p = found.mesh.points[a], &q = found.mesh.points[b], &s = found.mesh.points[c];
      EXPECT_GT((q - p).cross(s - p).dot((p + q + s) / 3 - found.joint.sphere.m), 0);
    }
    for (std::size_t i = 0; i < steps(found.before); ++i) {
      EXPECT_EQ((edges[{found.before[i], found.before[(i + 1) % found.before.size()]}]), 1);
    }
    for (std::size_t i = 0; i < steps(found.after); ++i) {
      EXPECT_EQ((edges[{found.after[(i + 1) % found.after.size()], found.after[i]}]), 1);
    }
  }
}

TEST(KneecapMesh, has_the_area_that_the_caps_leave) {
  for (const auto& spheres : joints()) {
    const auto missing = [&](double allowed) {
      const Kneecap found = kneecap(spheres, allowed, 0);
      return found.exposed_area - check(found.mesh, {.self_intersections = false}).area;
    };
    const double coarse = missing(0.004), fine = missing(0.00025);
    EXPECT_GT(coarse, 0);
    EXPECT_LT(coarse, 0.03);
    // Of second order: a sixteenth of it, but for rounding up numbers of segments.
    EXPECT_NEAR(coarse / fine, 16, 6);
  }
}

}  // namespace
}  // namespace dupin::tessellation
