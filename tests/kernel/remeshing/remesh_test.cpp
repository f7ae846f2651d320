#include "dupin/kernel/remesh.h"

#include <cmath>
#include <map>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/patch.h"
#include "dupin/kernel/rounding.h"
#include "support/pipe_unions.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using test::box;
using test::labelled;
using test::moved;
using test::tube;

constexpr double kDegree = M_PI / 180;

double smallest_angle(const TriMesh& mesh) {
  double least = M_PI;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 p[] = {mesh.points[a], mesh.points[b], mesh.points[c]};
    for (int i = 0; i < 3; ++i) {
      const Vec3 u = p[(i + 1) % 3] - p[i], v = p[(i + 2) % 3] - p[i];
      least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
  }
  return least;
}

double distance_to(const Vec3& p, const TriMesh& mesh) {
  double nearest = INFINITY;
  for (const auto& [i, k, l] : mesh.triangles) {
    const Vec3 corners[] = {mesh.points[i], mesh.points[k], mesh.points[l]};
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    bool inside = true;
    for (int j = 0; j < 3; ++j) {
      const Vec3 &q = corners[j], edge = corners[(j + 1) % 3] - q;
      inside = inside && normal.dot(edge.cross(p - q)) >= 0;
      const double t = std::clamp(edge.dot(p - q) / edge.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (q + t * edge - p).norm());
    }
    nearest = inside ? std::min(nearest, std::abs(normal.dot(p - corners[0]))) : nearest;
  }
  return nearest;
}

/// The largest distance of seeded random points of one mesh from the other.
double sampled_distance(const TriMesh& from, const TriMesh& to) {
  std::mt19937 random(29);
  std::uniform_real_distribution<double> unit(0, 1);
  double largest = 0;
  for (int i = 0; i < 300; ++i) {
    const Triangle& t = from.triangles[random() % from.triangles.size()];
    const double r = std::sqrt(unit(random)), s = unit(random);
    largest = std::max(largest,
                       distance_to((1 - r) * from.points[t[0]] + r * (1 - s) * from.points[t[1]] +
                                       r * s * from.points[t[2]],
                                   to));
  }
  return largest;
}

/// What every remeshing must do; the mesh that it made.
TriMesh expect_remeshed(const Solid& solid, const RemeshOptions& options, Remeshed& made) {
  made = remesh(solid, options);
  const TriMesh before = to_mesh(solid).mesh(), after = to_mesh(made.solid).mesh();
  EXPECT_TRUE(check(after).is_solid());
  EXPECT_EQ(made.solid.euler_number(), solid.euler_number());
  EXPECT_EQ(made.solid.shells(), solid.shells());
  EXPECT_LE(made.report.deviation, options.distance);
  EXPECT_LE(sampled_distance(before, after), made.report.deviation + 1e-9);
  EXPECT_LE(sampled_distance(after, before), made.report.deviation + 1e-9);
  EXPECT_NEAR(smallest_angle(after), made.report.smallest_angle, 1e-9);
  EXPECT_NEAR(made.solid.volume(), solid.volume(), solid.area() * options.distance);
  return after;
}

TEST(Remesh, of_a_box_keeps_it_exactly) {
  Remeshed made;
  expect_remeshed(Solid::from(box(Vec3::Zero(), Vec3(4, 2, 1))),
                  {.distance = 0.01, .largest_edge = 0.5}, made);
  EXPECT_EQ(made.solid.volume(), 8);
  EXPECT_EQ(made.report.poor_triangles, 0U);
  EXPECT_LE(made.report.longest_edge, 0.5 * 4 / 3 + 1e-12);
  EXPECT_GE(made.report.smallest_angle, 25 * kDegree);
}

TEST(Remesh, of_a_tube_has_the_angle_asked_for) {
  Remeshed made;
  const Solid given = Solid::from(tube(10, 0, 60, 128));
  const TriMesh after = expect_remeshed(given, {.distance = 0.1}, made);
  EXPECT_EQ(made.report.poor_triangles, 0U);
  EXPECT_GE(smallest_angle(after), 25 * kDegree);
  EXPECT_LT(smallest_angle(to_mesh(given).mesh()), 3 * kDegree);
}

TEST(Remesh, keeps_the_patches_of_a_union) {
  const Solid run = Solid::from(labelled(tube(10, 0, 60, 96), "run"));
  const Solid branch = Solid::from(labelled(moved(tube(4, 0, 60, 64), Vec3(3, 0, 30)), "branch"));
  const Solid both = unite(std::vector{run, branch});
  Remeshed made;
  const TriMesh after = expect_remeshed(both, {.distance = 0.05}, made);
  std::map<std::string, double> areas;
  for (const Patch& patch : patches_of(to_mesh(both).mesh())) {
    areas[patch.name] = patch.area;
  }
  for (const Patch& patch : patches_of(after)) {
    EXPECT_NEAR(patch.area, areas.at(patch.name), 0.01 * areas.at(patch.name)) << patch.name;
    areas.erase(patch.name);
  }
  EXPECT_TRUE(areas.empty());
  EXPECT_EQ(made.report.poor_triangles, made.report.confined_triangles);
}

TEST(Remesh, of_crossing_pipes_has_no_poor_triangles_but_between_sharp_edges) {
  for (const test::UnionKind kind : {test::UnionKind::equal, test::UnionKind::rotated}) {
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(std::string(test::name(kind)) + " " + std::to_string(seed));
      const Solid both = unite(test::pipes(kind, 48, seed));
      Remeshed made;
      expect_remeshed(both, {.distance = std::cbrt(both.volume()) / 500}, made);
      EXPECT_EQ(made.report.poor_triangles, made.report.confined_triangles);
    }
  }
}

TEST(Remesh, of_a_thin_plate_does_not_make_it_cross_itself) {
  Remeshed made;
  expect_remeshed(Solid::from(box(Vec3::Zero(), Vec3(10, 10, 0.01))),
                  {.distance = 0.1, .smallest_edge = 0.2}, made);
}

TEST(Remesh, is_the_same_on_any_number_of_threads) {
  const Solid both = unite(test::pipes(test::UnionKind::rotated, 32, 4));
  const RemeshOptions options{.distance = 0.02};
  TriMesh alone;
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    alone = to_mesh(remesh(both, options).solid).mesh();
  }
  const TriMesh together = to_mesh(remesh(both, options).solid).mesh();
  EXPECT_EQ(alone.triangles, together.triangles);
  EXPECT_EQ(alone.points, together.points);
}

TEST(Remesh, of_nothing_is_nothing) { EXPECT_TRUE(remesh(Solid(), {.distance = 1}).solid.empty()); }

TEST(Remesh, refuses_options_outside_their_range) {
  const Solid solid = Solid::from(box(Vec3::Zero(), Vec3(1, 1, 1)));
  const double nan = std::nan("");
  const std::pair<RemeshOptions, const char*> cases[] = {
      {{.distance = 0}, "distance of remeshing"},
      {{.distance = nan}, "distance of remeshing"},
      {{.distance = 1, .largest_edge = -1}, "lengths of edges"},
      {{.distance = 1, .smallest_edge = nan}, "lengths of edges"},
      {{.distance = 1, .largest_edge = 1, .smallest_edge = 2}, "smallest edge must not be longer"},
      {{.distance = 1, .smallest_angle = 1}, "between 0 and 30 degrees"},
      {{.distance = 1, .feature_angle = 0}, "between 0 and 180 degrees"},
  };
  for (const auto& [options, words] : cases) {
    try {
      (void)remesh(solid, options);
      ADD_FAILURE() << words;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
      EXPECT_THAT(error.what(), testing::HasSubstr(words));
    }
  }
}

}  // namespace
}  // namespace dupin
