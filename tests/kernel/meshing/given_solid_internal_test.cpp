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
  const RemeshReport report = given.report_of(given.mesh(), given.features().regions);
  EXPECT_GT(report.poor_triangles, 10U);
  ASSERT_EQ(report.worst.size(), 10U);
  EXPECT_EQ(report.worst.front().angle, report.smallest_angle);
  EXPECT_EQ(report.poor_between_edges, 0U);
  EXPECT_GE(report.longest_edge, 5);
  EXPECT_THAT(given.too_far({Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 0)}),
              testing::HasSubstr("near (1, 0, 0)"));
}

TEST(GivenSolid, tells_angles_that_edges_leave_no_choice) {
  // A wedge of some 6 degrees: the two triangles of each end have that angle at the tip.
  TriMesh wedge = test::box(Vec3::Zero(), Vec3(1, 1, 1));
  for (Vec3& p : wedge.points) {
    p.y() *= p.x() > 0 ? 0.1 : 0.001;
  }
  const Solid solid = Solid::from(wedge);
  const RemeshOptions options{.distance = 0.1};
  const GivenSolid given(solid, options);
  std::vector<std::uint32_t> each;  // triangle a region: all edges are borders
  for (std::uint32_t f = 0; f < given.mesh().triangles.size(); ++f) {
    each.push_back(f);
  }
  const RemeshReport report = given.report_of(given.mesh(), each);
  EXPECT_GT(report.poor_triangles, 0U);
  EXPECT_EQ(report.poor_between_edges, report.poor_triangles);
  EXPECT_TRUE(report.worst.front().is_between_edges);
  const std::vector<std::uint32_t> one(each.size(), 0);
  EXPECT_EQ(given.report_of(given.mesh(), one).poor_between_edges, 0U);
}

}  // namespace
}  // namespace dupin::meshing
