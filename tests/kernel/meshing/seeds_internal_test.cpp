#include <gtest/gtest.h>

#include "meshing/seeds.h"
#include "support/shapes.h"

namespace dupin::meshing {
namespace {

TEST(Seeds, are_on_their_regions_and_needed_where_there_is_no_curve) {
  for (const double sharp : {0.7, 3.1}) {  // with the second, all is one region
    const TriMesh mesh = test::tube(3, 0, 5, 24);
    const Features features = find_features(mesh, sharp, 0.01, 0);
    const mesh::ReferenceSurface surface(mesh.points, mesh.triangles, features.regions);
    const std::vector<Seed> seeds =
        seeds_of(mesh, features, surface, EdgeLengths(surface, features, 0.01, 1));
    const bool is_one = features.curves.empty();
    EXPECT_EQ(is_one, sharp > 3);
    EXPECT_EQ(seeds.size(), (is_one ? 1U : 3U) * 9U);
    for (const Seed& seed : seeds) {
      EXPECT_EQ(seed.is_needed, is_one);
      const auto near = surface.nearest(seed.point, seed.region, 1e-9);
      EXPECT_TRUE(near.has_value());
    }
  }
}

}  // namespace
}  // namespace dupin::meshing
