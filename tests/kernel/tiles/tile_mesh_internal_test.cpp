#include <map>

#include <gtest/gtest.h>

#include "kernel/tiles/facet_scene.h"
#include "support/none.h"
#include "tiles/tile_mesh.h"

namespace dupin::tiles {
namespace {

// All tiles' meshes together are the whole's, in its numbers.
TEST(TileMesh, numbers_points_as_the_whole_does) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const std::vector<Facet> facets = test::facet_scene(seed, 0.1);
    const TriMesh whole = test::welded_mesh(facets);
    std::vector<Place> sample;
    for (const Facet& facet : facets) {
      sample.push_back(box_of(facet).low);
    }
    const TileTree tree(sample, 6);
    std::vector<std::vector<TileFacet>> tiles(tree.size());
    std::uint32_t seams = 0;
    for (std::uint32_t number = 0; number < facets.size(); ++number) {
      std::vector<std::uint32_t> in;
      tree.for_each_tile(box_of(facets[number]), [&](std::uint32_t tile) { in.push_back(tile); });
      const std::uint32_t seam = in.size() > 1 ? seams++ : support::kNone;
      for (const std::uint32_t tile : in) {
        tiles[tile].push_back({facets[number], number, seam});
      }
    }
    FirstCorners first(facets.size());
    SeamCorners corners(3 * std::size_t{seams});
    for (std::uint32_t tile = 0; tile < tiles.size(); ++tile) {
      note_first_corners(tiles[tile], welded(tiles[tile], tree, tile), first, corners);
    }
    first.count();
    EXPECT_EQ(first.size(), whole.points.size());
    std::vector<int> owned(whole.points.size()), faces_owned(facets.size());
    for (std::uint32_t tile = 0; tile < tiles.size(); ++tile) {
      const TileMesh own = tile_mesh(tiles[tile], welded(tiles[tile], tree, tile), first, corners);
      EXPECT_TRUE(std::ranges::is_sorted(own.points));
      for (std::size_t i = 0; i < own.points.size(); ++i) {
        EXPECT_EQ(own.mesh.points[i], whole.points[own.points[i]]);
        owned[own.points[i]] += own.owns_point[i];
      }
      for (std::size_t i = 0; i < tiles[tile].size(); ++i) {
        const std::uint32_t number = tiles[tile][i].number;
        faces_owned[number] += own.owns_face[i];
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_EQ(own.points[own.mesh.triangles[i][k]], whole.triangles[number][k]);
        }
      }
    }
    EXPECT_EQ(owned, std::vector<int>(owned.size(), 1));
    EXPECT_EQ(faces_owned, std::vector<int>(faces_owned.size(), 1));
  }
}

TEST(FirstCorners, are_ranked) {
  FirstCorners first(1000);
  for (std::uint64_t corner = 0; corner < 3000; corner += 7) {
    first.set(corner);
  }
  first.count();
  EXPECT_EQ(first.size(), 429);
  for (std::uint64_t corner = 0; corner < 3000; ++corner) {
    EXPECT_EQ(first.rank(corner), (corner + 6) / 7);
  }
}

}  // namespace
}  // namespace dupin::tiles
