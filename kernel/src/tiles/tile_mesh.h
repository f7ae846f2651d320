#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/tiled_check.h"
#include "tiles/first_corners.h"
#include "tiles/tile_tree.h"

namespace dupin::tiles {

/// A facet as a tile keeps it.
struct TileFacet {
  Facet corners;
  std::uint32_t number;  ///< in the whole
  std::uint32_t seam;    ///< its number among those in several tiles, or support::kNone
};

[[nodiscard]] Place corner_of(const Facet& facet, std::size_t corner);
[[nodiscard]] PlaceBox box_of(const Facet& facet);
[[nodiscard]] Vec3 to_vec3(const Place& place);

/// Of the corners of facets in several tiles, three for each: the first corner at the same place,
/// as the tile knows that the place is in.
using SeamCorners = std::vector<std::uint64_t>;

/// Corners at one place are one point, in order of appearance in the tile.
struct WeldedTile {
  std::vector<Triangle> triangles;          ///< one per facet
  std::vector<std::uint64_t> first_corner;  ///< of each point, as far as the tile shows it
  std::vector<std::uint8_t> is_own;         ///< whether the point is in the tile
};

/// `facets` are in the order of the whole.
[[nodiscard]] WeldedTile welded(std::span<const TileFacet> facets, const TileTree& tree,
                                std::uint32_t tile);

/// Notes the first corners of the points in the tile.
void note_first_corners(std::span<const TileFacet> facets, const WeldedTile& tile,
                        FirstCorners& first, SeamCorners& seams);

/// A tile's facets as a mesh, its points in the order of the whole.
struct TileMesh {
  TriMesh mesh;
  std::vector<std::uint32_t> points;  ///< the numbers of points in the whole, ascending
  std::vector<std::uint8_t> owns_point, owns_face;
};

/// The first corners of all tiles have been noted.
[[nodiscard]] TileMesh tile_mesh(std::span<const TileFacet> facets, WeldedTile tile,
                                 const FirstCorners& first, const SeamCorners& seams);

}  // namespace dupin::tiles
