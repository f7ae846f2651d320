#include <cmath>

#include <gtest/gtest.h>

#include "remeshing/steps.h"
#include "support/shapes.h"
#include "workshop_internal.h"

namespace dupin::remeshing {
namespace {

using test::Bench;

std::pair<double, double> edges_of(const WorkingMesh& mesh) {
  double least = INFINITY, most = 0;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; mesh.alive(f) && i < 3; ++i) {
      const double length = mesh.length(mesh.face(f).corners[i], mesh.face(f).corners[(i + 1) % 3]);
      least = std::min(least, length);
      most = std::max(most, length);
    }
  }
  return {least, most};
}

/// One call makes a few rounds; how many edits calls make until there are none left.
std::size_t all_of(std::size_t (&step)(Workshop&), Bench& bench) {
  std::size_t all = 0;
  for (std::size_t made = step(bench.shop); made > 0; made = step(bench.shop)) {
    all += made;
  }
  return all;
}

TEST(Steps, split_until_edges_are_short_and_collapse_until_they_are_long) {
  Bench bench(dupin::test::box(Vec3::Zero(), Vec3(1, 1, 1)), {0.01, 0.1, 0.001});
  EXPECT_GT(all_of(split_long_edges, bench), 100U);
  EXPECT_LE(edges_of(bench.working).second, 0.1 * 4 / 3);
  for (std::uint32_t v = 0; v < bench.working.point_count(); ++v) {
    bench.working.point(v).size = 2;
  }
  EXPECT_GT(all_of(collapse_short_edges, bench), 100U);
  EXPECT_GE(edges_of(bench.working).first, 0.5);
  EXPECT_EQ(Solid::from(bench.working.compact().first).volume(), 1);
}

TEST(Steps, flips_make_angles_larger) {
  TriMesh mesh = dupin::test::tube(1, 0, 0.1, 64);
  Bench bench(mesh, {0.01, 1, 0.01});
  const double before = test::smallest_sine_of(bench.working);
  EXPECT_GT(flip_edges(bench.shop), 10U);  // the fans of the ends
  EXPECT_GE(test::smallest_sine_of(bench.working), before);
}

TEST(Steps, poor_triangles_vanish) {
  TriMesh mesh = dupin::test::box(Vec3::Zero(), Vec3(1, 1, 1));
  Bench bench(mesh, {0.001, 0.25, 0.001});
  all_of(split_long_edges, bench);
  bench.shop.least_sine = std::sin(0.5);
  for (int i = 0; i < 4; ++i) {
    collapse_poor(bench.shop);
    split_below_poor(bench.shop);
    flip_edges(bench.shop);
  }
  EXPECT_GE(test::smallest_sine_of(bench.working), std::sin(0.4));
}

}  // namespace
}  // namespace dupin::remeshing
