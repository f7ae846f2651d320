#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "meshing/given_solid.h"
#include "support/shapes.h"

namespace dupin::meshing {
namespace {

const Solid kTube = Solid::from(test::labelled(test::tube(3, 0, 5, 24), "tube"));

TEST(GivenSolid, knows_its_regions_and_chooses_a_length) {
  const RemeshOptions options{.distance = 0.1};
  const GivenSolid given(kTube, options);
  EXPECT_EQ(given.region_count(), 3U);
  EXPECT_EQ(given.features().regions.size(), given.mesh().triangles.size());
  EXPECT_GT(given.slack(), 0);
  EXPECT_LT(given.slack(), 1e-12);
  EXPECT_NEAR(given.largest_edge(), 0.1 * std::sqrt(36 + 36 + 25), 1e-9);
  EXPECT_LT(given.move_limits().distance, options.distance);
}

TEST(GivenSolid, tells_other_solids_by_shells_and_handles) {
  const RemeshOptions options{.distance = 0.1};
  const GivenSolid given(kTube, options);
  EXPECT_TRUE(given.hangs_together_as(Solid::from(test::box(Vec3::Zero(), Vec3(1, 1, 1)))));
  EXPECT_FALSE(given.hangs_together_as(Solid::from(test::frame())));
}

TEST(GivenSolid, labels_triangles_by_their_regions) {
  const RemeshOptions options{.distance = 0.1};
  const GivenSolid given(kTube, options);
  TriMesh mesh = given.mesh();
  mesh.labels.clear();
  mesh.names.clear();
  given.label(mesh, given.features().regions);
  EXPECT_EQ(mesh.labels, given.mesh().labels);
  EXPECT_EQ(mesh.names, given.mesh().names);
}

TEST(GivenSolid, reports_the_smallest_angles_with_their_places) {
  const RemeshOptions options{.distance = 0.1};
  const GivenSolid given(kTube, options);
  const RemeshReport report = given.report_of(given.mesh());
  EXPECT_GT(report.poor_triangles, 10U);
  ASSERT_EQ(report.worst.size(), 10U);
  EXPECT_EQ(report.worst.front().angle, report.smallest_angle);
  EXPECT_GE(report.longest_edge, 5);
  EXPECT_THAT(given.too_far({Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 0)}),
              testing::HasSubstr("near 1 0 0"));
}

}  // namespace
}  // namespace dupin::meshing
