#include "dupin/kernel/simplify.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "support/mesh_distance.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using test::sampled_distance;

/// A tube in rings, tilted off the axes, the two halves labelled "low" and "high".
TriMesh ringed_tube(std::uint32_t segments, std::uint32_t rings) {
  const Eigen::AngleAxisd tilt(0.7, Vec3(1, 2, 3).normalized());
  TriMesh mesh;
  mesh.names = {"low", "high"};
  const auto add = [&](const Triangle& triangle, std::uint32_t label) {
    mesh.triangles.push_back(triangle);
    mesh.labels.push_back(label);
  };
  for (std::uint32_t j = 0; j <= rings; ++j) {
    for (std::uint32_t i = 0; i < segments; ++i) {
      const double angle = 2 * 3.141592653589793 * i / segments;
      mesh.points.push_back(tilt * Vec3(std::cos(angle), std::sin(angle), 4.0 * j / rings));
    }
  }
  for (std::uint32_t a = 0; a < segments * rings; ++a) {
    const std::uint32_t b = a % segments + 1 == segments ? a + 1 - segments : a + 1;
    const std::uint32_t label = a < segments * (rings / 2) ? 0 : 1;
    add({a, b, b + segments}, label);
    add({a, b + segments, a + segments}, label);
  }
  const std::uint32_t top = segments * rings;
  for (std::uint32_t i = 1; i + 1 < segments; ++i) {
    add({0, i + 1, i}, 0);
    add({top, top + i, top + i + 1}, 1);
  }
  return mesh;
}

TEST(Simplify, keeps_only_the_rings_that_matter) {
  constexpr std::uint32_t kSegments = 24;
  const TriMesh tube = ringed_tube(kSegments, 16);
  const Simplified result = simplify(Solid::from(tube), 1e-9);
  EXPECT_TRUE(check(result.mesh).is_solid());
  EXPECT_EQ(result.mesh.points.size(), 3 * kSegments) << "both ends and the border of labels";
  EXPECT_EQ(result.mesh.triangles.size(), 2 * (3 * kSegments) - 4) << "Euler";
  EXPECT_EQ(result.removed_triangles, tube.triangles.size() - result.mesh.triangles.size());
  EXPECT_LE(result.deviation, 1e-9);
}

/// Of rings of segments, tilted off the axes by that angle.
TriMesh ball(std::uint32_t segments, std::uint32_t rings, double angle) {
  const Eigen::AngleAxisd tilt(angle, Vec3(1, 2, 3).normalized());
  TriMesh mesh;
  mesh.points.push_back(tilt * Vec3(0, 0, 1));
  for (std::uint32_t a = 0; a < segments * rings; ++a) {
    const double turn = 2 * 3.141592653589793 * (a % segments) / segments;
    const double down = 3.141592653589793 * (a / segments + 1) / (rings + 1);
    mesh.points.push_back(tilt * Vec3(std::sin(down) * std::cos(turn),
                                      std::sin(down) * std::sin(turn), std::cos(down)));
  }
  mesh.points.push_back(tilt * Vec3(0, 0, -1));
  const std::uint32_t last = segments * rings + 1;
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t next = (i + 1) % segments;
    mesh.triangles.push_back({0, 1 + i, 1 + next});
    mesh.triangles.push_back({last, last - segments + next, last - segments + i});
    for (std::uint32_t above = 1; above + segments < last; above += segments) {
      mesh.triangles.push_back({above + i, above + segments + i, above + segments + next});
      mesh.triangles.push_back({above + i, above + segments + next, above + next});
    }
  }
  return mesh;
}

// A few points are left, of which one may go to the other side of all other faces.
TEST(Simplify, turns_no_shell_inside_out) {
  for (const TriMesh& round : {ball(10, 7, 0), ball(6, 6, 0.3), ball(9, 5, 0.9), ball(5, 7, 2.1)}) {
    const TriMesh hollow =
        test::joined({test::box({-9, -9, -9}, {9, 9, 9}), test::reversed(round)});
    for (const double tolerance : {1.0, 3.0, 10.0}) {
      SCOPED_TRACE(tolerance);
      for (const TriMesh& mesh : {round, hollow}) {
        const Simplified result = simplify(Solid::from(mesh), tolerance);
        EXPECT_TRUE(check(result.mesh).is_solid());
        EXPECT_GT(result.removed_triangles, round.triangles.size() / 2);
      }
    }
  }
}

// Chords of a coarser tube run on the other side of small voids near its surface, and chords of a
// coarser bore on that of small bodies in it.
TEST(Simplify, passes_over_no_shell) {
  TriMesh tube = ringed_tube(96, 4);
  tube.labels.clear();
  tube.names.clear();
  const Vec3 axis = (tube.points[96] - tube.points[0]).normalized();
  std::vector<TriMesh> voids = {tube},
                       bodies = {test::box({-2, -2, -2}, {6, 6, 6}), test::reversed(tube)};
  for (std::size_t i = 96; i < 192; i += 5) {
    const Vec3 place = (tube.points[i] + tube.points[i + 96]) / 2;
    const Vec3 out = place - axis * place.dot(axis);
    const TriMesh tiny = test::tetrahedron(place - 0.004 * out, 0.001);
    voids.push_back(test::reversed(tiny));
    bodies.push_back(tiny);
  }
  for (const auto& parts : {voids, bodies}) {
    const Solid solid = Solid::from(test::joined(parts));
    for (const double tolerance : {0.01, 0.05, 0.2}) {
      const Simplified result = simplify(solid, tolerance);
      EXPECT_TRUE(check(result.mesh).is_solid()) << tolerance;
      EXPECT_GT(result.removed_triangles, 400) << tolerance;
    }
  }
}

// Collapses beside that edge took one sheet through the other there, where no two triangles cross,
// and made other edges touch.
TEST(Simplify, keeps_edges_at_which_the_solid_touches_itself) {
  constexpr double kThird = 1.0 / 3;
  const Vec3 low(0.5, 1, 0), high(5 * kThird, 10 * kThird, 0);
  TriMesh mesh;
  mesh.points = {{0, 1, 0},
                 {4, 1, 0},
                 {0, 5, 0},
                 {0, 1, 1},
                 {4, 1, 1},
                 {0, 5, 1},
                 {2, 3, 1},
                 low,
                 {1, 1.5, 1},
                 low,
                 high,
                 high,
                 {2 * kThird, 1, 2 * kThird},
                 {5.5 * kThird, 9.5 * kThird, 1},
                 {2 * kThird, 1, kThird}};
  mesh.triangles = {{2, 0, 5},   {0, 3, 5},   {12, 4, 3},  {12, 3, 0},  {12, 1, 4},  {12, 0, 7},
                    {14, 1, 12}, {9, 1, 14},  {0, 2, 10},  {10, 7, 0},  {11, 1, 9},  {4, 6, 8},
                    {8, 13, 5},  {3, 4, 8},   {8, 5, 3},   {10, 2, 5},  {5, 13, 10}, {1, 6, 4},
                    {1, 11, 6},  {11, 14, 6}, {14, 11, 9}, {14, 12, 8}, {14, 8, 6},  {8, 7, 10},
                    {7, 8, 12},  {8, 10, 13}};
  for (const TriMesh& side :
       {mesh, test::joined({test::box({-9, -9, -9}, {9, 9, 9}), test::reversed(mesh)})}) {
    const Solid solid = Solid::from(side);
    ASSERT_EQ(solid.contacts().size(), 1);
    for (const double tolerance : {0.9, 1.0, 1.2, 2.0, 5.0}) {
      SCOPED_TRACE(tolerance);
      const Simplified result = simplify(solid, tolerance);
      const Report report = check(result.mesh);
      EXPECT_TRUE(report.is_solid());
      EXPECT_EQ(report.count(Defect::contact), 1);
      EXPECT_GT(result.removed_triangles, 0);
      const Contact left = Solid::from(result.mesh).contacts().at(0);
      EXPECT_EQ(left.from, solid.contacts()[0].from);
      EXPECT_EQ(left.to, solid.contacts()[0].to);
    }
  }
}

TEST(Simplify, ignores_borders_where_there_are_no_labels) {
  TriMesh tube = ringed_tube(24, 16);
  tube.labels.clear();
  tube.names.clear();
  EXPECT_EQ(simplify(Solid::from(tube), 1e-9).mesh.points.size(), 48);
}

TEST(Simplify, stays_within_the_tolerance) {
  const TriMesh tube = ringed_tube(64, 16);
  std::size_t triangles = tube.triangles.size();
  for (const double tolerance : {1e-9, 1e-2, 1e-1}) {
    const Simplified result = simplify(Solid::from(tube), tolerance);
    const Report report = check(result.mesh);
    EXPECT_TRUE(report.is_solid());
    EXPECT_LE(result.deviation, tolerance);
    EXPECT_LE(sampled_distance(tube, result.mesh), result.deviation);
    EXPECT_LE(sampled_distance(result.mesh, tube), result.deviation);
    EXPECT_LT(result.mesh.triangles.size(), triangles) << "more tolerance, fewer triangles";
    triangles = result.mesh.triangles.size();
  }
}

TEST(Simplify, keeps_the_borders_of_labels) {
  const TriMesh tube = ringed_tube(48, 8);
  const Simplified result = simplify(Solid::from(tube), 0.05);
  ASSERT_EQ(result.mesh.labels.size(), result.mesh.triangles.size());
  for (std::uint32_t i = 4 * 48; i < 5 * 48; ++i) {
    EXPECT_THAT(result.mesh.points, testing::Contains(tube.points[i])) << "of the middle ring";
  }
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    EXPECT_EQ(result.mesh.labels[f], tube.labels[result.sources[f].triangle]);
  }
}

TEST(Simplify, leaves_what_has_nothing_to_spare) {
  const TriMesh box = test::box(Vec3(0, 0, 0), Vec3(1, 2, 3));
  const Simplified result = simplify(Solid::from(box), 0.1);
  EXPECT_EQ(result.mesh.triangles, box.triangles);
  EXPECT_EQ(result.deviation, 0);
}

TEST(Simplify, tells_how_far_it_is_and_can_be_ended) {
  const Solid tube = Solid::from(ringed_tube(64, 16));
  double last = 0;
  std::size_t told = 0;
  (void)simplify(tube, 0.1, [&](std::string_view stage, double fraction) {
    EXPECT_EQ(stage, "simplify");
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    last = fraction;
    ++told;
    return true;
  });
  EXPECT_GT(told, 1);
  EXPECT_GT(last, 0);
  try {
    (void)simplify(tube, 0.1, [](std::string_view, double fraction) { return fraction == 0; });
    ADD_FAILURE() << "it went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::cancelled);
  }
}

TEST(Simplify, refuses_senseless_tolerances) {
  const Solid solid = Solid::from(test::tetrahedron());
  for (const double tolerance :
       {0.0, -1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    try {
      static_cast<void>(simplify(solid, tolerance));
      ADD_FAILURE() << tolerance;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
    }
  }
}

}  // namespace
}  // namespace dupin
