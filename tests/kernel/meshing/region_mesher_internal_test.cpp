#include <gtest/gtest.h>

#include "kernel/meshing/solver_mesh_checks.h"
#include "meshing/edge_lengths.h"
#include "meshing/region_mesher.h"
#include "support/shapes.h"

namespace dupin::meshing {
namespace {

struct Case {
  explicit Case(const TriMesh& mesh, double distance = 0.05)
      : solid(Solid::from(mesh)),
        options{.distance = distance, .largest_edge = 1},
        given(solid, options),
        lengths(given.surface(), given.features(), distance / 2, 0.9),
        points(points_along(given.features(), lengths,
                            std::vector<double>(given.features().curves.size(), 1), 10'000)),
        regions(regions_of(given)) {}

  [[nodiscard]] CurvePoints balls(std::size_t region) const {
    // Points of all curves; those of others are at no chain.
    CurvePoints balls{points.points, {}};
    for (const std::uint32_t c : regions[region].curves) {
      balls.chains.push_back(points.chains[c]);
    }
    return balls;
  }
  Solid solid;
  RemeshOptions options;
  GivenSolid given;
  EdgeLengths lengths;
  CurvePoints points;
  std::vector<Region> regions;
};

TEST(RegionMesher, cuts_a_solid_into_its_regions) {
  const Case tube(test::tube(2, 0, 6, 64));
  ASSERT_EQ(tube.regions.size(), 3U);
  std::size_t triangles = 0;
  for (const Region& region : tube.regions) {
    triangles += region.mesh.triangles.size();
    EXPECT_EQ(region.curves.size(), region.features.curves.size());
    EXPECT_EQ(region.curves.size(), region.sides.size());
    for (const std::uint32_t sides : region.sides) {
      EXPECT_EQ(sides, 1U);
    }
  }
  EXPECT_EQ(triangles, tube.solid.triangle_count());
}

TEST(RegionMesher, meshes_flat_and_round_regions_to_their_curves) {
  const Case tube(test::tube(2, 0, 6, 64));
  for (std::size_t r = 0; r < tube.regions.size(); ++r) {
    RegionWish wish;
    const auto made = mesh_region(tube.regions[r], tube.balls(r), tube.given, wish, {});
    ASSERT_TRUE(made.has_value()) << wish.fault;
    EXPECT_LE(made->deviation, 0.05);
    const TriMesh mesh{made->points, made->triangles, {}, {}};
    EXPECT_GE(test::smallest_angle(mesh), 25 * test::kDegree);
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3 &p = mesh.points[a], &q = mesh.points[b], &s = mesh.points[c];
      const Vec3 normal = (q - p).cross(s - p), middle = (p + q + s) / 3;
      EXPECT_GT(normal.dot(middle - Vec3(0, 0, 3)), 0) << "turned outward";
    }
  }
}

TEST(RegionMesher, refines_once_and_cuts_edges_that_are_too_far_off) {
  for (const double radius : {1.4, 1.7, 2.0, 2.3, 2.6}) {
    const Case tube(test::tube(radius, 0, 6, 64));
    for (std::size_t r = 0; r < tube.regions.size(); ++r) {
      RegionWish wish;
      const auto made = mesh_region(tube.regions[r], tube.balls(r), tube.given, wish, {});
      ASSERT_TRUE(made.has_value()) << wish.fault;
      EXPECT_EQ(wish.share, RegionWish().share) << "more was asked for, radius " << radius;
      EXPECT_LE(made->deviation, 0.05);
      EXPECT_GE(test::smallest_angle({made->points, made->triangles, {}, {}}), 25 * test::kDegree);
    }
  }
}

TEST(RegionMesher, says_why_there_is_no_mesh) {
  // Points so far apart that edges between them are not within the distance.
  Case tube(test::tube(2, 0, 6, 64), 0.05);
  const EdgeLengths coarse(tube.given.surface(), tube.given.features(), 10, 1.5);
  tube.points = points_along(tube.given.features(), coarse, {1, 1}, 1000);
  RegionWish wish;
  EXPECT_FALSE(mesh_region(tube.regions[0], tube.balls(0), tube.given, wish, {}).has_value());
  EXPECT_NE(wish.fault.find("the distance of 0.05 cannot be kept near ("), std::string::npos)
      << wish.fault;
}

}  // namespace
}  // namespace dupin::meshing
