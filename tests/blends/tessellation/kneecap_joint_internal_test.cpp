#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_tube.h"
#include "support/cyclide_cases.h"
#include "tessellation/kneecap_joint.h"

namespace dupin::tessellation {
namespace {

using std::numbers::pi;
using test::corner_spheres;
using test::cylinder_to_cone_spheres;

JointCircles joint_of(const std::vector<PeVector>& spheres, double negligible = 0,
                      double grid = 0) {
  const std::vector<PeArc> pieces = through_all(spheres);
  return joint(pieces.at(0), pieces.at(1), negligible, grid);
}

// How far a point is ahead of a circle's plane.
double ahead_of(const Ring& circle, const Vec3& point) {
  return (point - circle.center).dot(circle.normal);
}

// The angle about the circle's normal, in [0, 2 pi).
double angle_between(const Ring& circle, const Vec3& from, const Vec3& to) {
  const Vec3 a = from - circle.center, b = to - circle.center;
  const double angle = std::atan2(circle.normal.dot(a.cross(b)), a.dot(b));
  return angle < 0 ? angle + 2 * pi : angle;
}

std::vector<std::vector<PeVector>> lunes() {
  return {test::lune_spheres(),
          corner_spheres(0.02),
          corner_spheres(1),
          corner_spheres(2),
          cylinder_to_cone_spheres(-0.2, 1),
          cylinder_to_cone_spheres(0.3, 2)};
}

TEST(KneecapJoint, is_of_the_kind_that_the_circles_make_it) {
  struct Row {
    std::vector<PeVector> spheres;
    double negligible, grid;
    JointKind kind;
  };
  const Row rows[] = {
      {corner_spheres(0), 1e-12, 0, JointKind::smooth},
      {corner_spheres(1e-4), 1e-3, 0, JointKind::smooth},
      {corner_spheres(1e-4), 1e-5, 0, JointKind::lune},
      {corner_spheres(1), 1e-3, 0, JointKind::lune},
      {cylinder_to_cone_spheres(-0.2, 0), 1e-3, 0, JointKind::band},
      {cylinder_to_cone_spheres(-0.2, 0.15), 1e-3, 0, JointKind::band},
      {cylinder_to_cone_spheres(-0.2, 0.25), 1e-3, 0, JointKind::lune},
      {cylinder_to_cone_spheres(0.2, 0), 1e-3, 0, JointKind::hidden},
      {cylinder_to_cone_spheres(0.2, 0.15), 1e-3, 0, JointKind::hidden},
      // Circles that cross within a cell of the grid do not.
      {cylinder_to_cone_spheres(-0.2, std::asin(0.2) + 1e-6), 0, 0, JointKind::lune},
      {cylinder_to_cone_spheres(0.2, std::asin(0.2) + 1e-6), 0, 0x1p-8, JointKind::hidden},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(&row - rows);
    const JointCircles found = joint_of(row.spheres, row.negligible, row.grid);
    EXPECT_EQ(found.kind, row.kind);
    EXPECT_EQ(found.sphere, row.spheres[2]);
    EXPECT_LE(found.apart, row.negligible);
    EXPECT_EQ(found.before == found.after, found.kind == JointKind::smooth);
    for (const Ring& circle : {found.before, found.after}) {
      EXPECT_NEAR(found.hinge.dot(circle.normal), 0, 1e-6);
      EXPECT_NEAR((circle.center - found.sphere.m).squaredNorm() + circle.radius * circle.radius, 1,
                  1e-12);
    }
  }
}

TEST(KneecapJoint, of_a_lune_has_its_corners_where_the_circles_cross) {
  for (const auto& spheres : lunes()) {
    const JointCircles found = joint_of(spheres);
    ASSERT_EQ(found.kind, JointKind::lune);
    const auto& [first, second] = found.corners;
    for (const Vec3& corner : found.corners) {
      EXPECT_NEAR((corner - found.sphere.m).norm(), found.sphere.r, 1e-13);
      EXPECT_NEAR(ahead_of(found.before, corner), 0, 1e-13);
      EXPECT_NEAR(ahead_of(found.after, corner), 0, 1e-13);
    }
    // Counter-clockwise from the first to the second, the circles bound what neither piece covers.
    for (const auto& [circle, other, side] :
         {std::tuple(found.before, found.after, -1), {found.after, found.before, 1}}) {
      const Vec3 middle = circle.center + circle.radius * outward(found, circle.normal);
      EXPECT_GT(side * ahead_of(other, middle), 0);
      EXPECT_LT(angle_between(circle, first, middle), angle_between(circle, first, second));
    }
  }
}

// What every polygon of a joint keeps.
void expect_inscribed(const JointPolygon& polygon, const Ring& circle, std::uint32_t segments,
                      double grid) {
  ASSERT_EQ(polygon.points.size(), segments);
  ASSERT_EQ(polygon.angles.size(), segments);
  EXPECT_EQ(polygon.angles.front(), 0);
  for (std::uint32_t i = 0; i < segments; ++i) {
    const double next = i + 1 < segments ? polygon.angles[i + 1] : 2 * pi;
    EXPECT_GT(next, polygon.angles[i]);
    EXPECT_LE(next - polygon.angles[i], 2 * pi / (segments - 1) + 1e-12);
    const Vec3 meant =
        circle.center +
        circle.radius * (Eigen::AngleAxisd(polygon.angles[i], circle.normal) * polygon.first);
    EXPECT_LE((polygon.points[i] - meant).norm(), std::numbers::sqrt3 / 2 * grid + 1e-13);
    EXPECT_EQ(polygon.points[i], snapped(polygon.points[i], grid));
  }
}

TEST(JointPolygon, of_a_lune_runs_through_its_corners) {
  constexpr double kGrid = 0x1p-20;
  for (const auto& spheres : lunes()) {
    const JointCircles found = joint_of(spheres);
    for (const std::uint32_t segments : {8U, 13U, 64U}) {
      for (const auto& [circle, other, side] :
           {std::tuple(found.before, found.after, -1), {found.after, found.before, 1}}) {
        const JointPolygon polygon = joint_polygon(found, circle, segments, kGrid);
        expect_inscribed(polygon, circle, segments, kGrid);
        ASSERT_GT(polygon.exposed, 0U);
        ASSERT_LT(polygon.exposed, segments);
        EXPECT_EQ(polygon.points.front(), snapped(found.corners[0], kGrid));
        EXPECT_EQ(polygon.points[polygon.exposed], snapped(found.corners[1], kGrid));
        for (std::uint32_t i = 1; i < segments; ++i) {
          if (i != polygon.exposed) {
            EXPECT_EQ(side * ahead_of(other, polygon.points[i]) > 0, i < polygon.exposed);
          }
        }
      }
    }
  }
}

TEST(JointPolygon, of_a_band_begins_past_its_narrowest_place) {
  constexpr std::uint32_t kSegments = 16;
  const JointCircles found = joint_of(cylinder_to_cone_spheres(-0.2, 0.15));
  ASSERT_EQ(found.kind, JointKind::band);
  for (const auto& [circle, other] :
       {std::pair(found.before, found.after), {found.after, found.before}}) {
    const JointPolygon polygon = joint_polygon(found, circle, kSegments, 0);
    expect_inscribed(polygon, circle, kSegments, 0);
    EXPECT_EQ(polygon.exposed, kSegments);
    EXPECT_EQ(polygon.first, band_start(found, circle.normal, kSegments));
    // On a sphere, the distance from the other circle grows with that from its plane.
    double narrowest = 0, least = 10;
    constexpr int kSteps = 100'000;
    for (int i = 0; i < kSteps; ++i) {
      const double angle = 2 * pi * i / kSteps;
      const Eigen::AngleAxisd turn(angle, circle.normal);
      const double off =
          std::abs(ahead_of(other, circle.center + circle.radius * (turn * polygon.first)));
      if (off < least) {
        least = off;
        narrowest = angle;
      }
    }
    EXPECT_NEAR(2 * pi - narrowest, pi / kSegments, 1e-3);
  }
}

TEST(JointPolygon, of_circles_that_show_nothing_is_exposed_nowhere) {
  const JointCircles hidden = joint_of(cylinder_to_cone_spheres(0.2, 0.15));
  for (const Ring& circle : {hidden.before, hidden.after}) {
    const JointPolygon polygon = joint_polygon(hidden, circle, 16, 0);
    expect_inscribed(polygon, circle, 16, 0);
    EXPECT_EQ(polygon.exposed, 0U);
  }
}

TEST(JointPolygon, of_a_smooth_joint_is_the_same_from_both_sides) {
  const JointCircles found = joint_of(corner_spheres(1e-4), 1e-3);
  const JointPolygon before = joint_polygon(found, found.before, 9, 0x1p-20);
  const JointPolygon after = joint_polygon(found, found.after, 9, 0x1p-20);
  EXPECT_EQ(before.points, after.points);
  EXPECT_EQ(before.exposed, 0U);
  expect_inscribed(before, found.before, 9, 0x1p-20);
  // No point of either piece's own circle is further off.
  const std::vector<PeArc> pieces = through_all(corner_spheres(1e-4));
  const Ring own = circle_at(pieces[1], 0);
  const double turned = (own.normal - found.before.normal).norm();
  EXPECT_GE(found.apart, own.radius * turned + (own.center - found.before.center).norm() - 1e-15);
}

}  // namespace
}  // namespace dupin::tessellation
