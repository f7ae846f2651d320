#include "tiles/tile_mesh.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <numeric>
#include <utility>

#include "support/key_numbering.h"
#include "support/none.h"

namespace dupin::tiles {
namespace {

support::KeyNumbering::Key key_of(const Place& place) {
  const auto bits = [&](std::size_t k) {
    return std::uint64_t{std::bit_cast<std::uint32_t>(place[k])};
  };
  return {bits(0) << 32 | bits(1), bits(2)};
}

std::uint64_t corner_number(const TileFacet& facet, std::size_t k) {
  return 3 * std::uint64_t{facet.number} + k;
}

}  // namespace

Place corner_of(const Facet& facet, std::size_t corner) {
  return {facet[3 * corner], facet[3 * corner + 1], facet[3 * corner + 2]};
}

PlaceBox box_of(const Facet& facet) {
  PlaceBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = std::min({facet[k], facet[3 + k], facet[6 + k]});
    box.high[k] = std::max({facet[k], facet[3 + k], facet[6 + k]});
  }
  return box;
}

Vec3 to_vec3(const Place& place) { return {place[0], place[1], place[2]}; }

WeldedTile welded(std::span<const TileFacet> facets, const TileTree& tree, std::uint32_t tile) {
  WeldedTile result;
  result.triangles.reserve(facets.size());
  support::KeyNumbering numbering(facets.size() / 2);
  for (const TileFacet& facet : facets) {
    Triangle& corners = result.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Place place = corner_of(facet.corners, k);
      corners[k] = numbering.number(key_of(place));
      if (corners[k] == result.first_corner.size()) {
        result.first_corner.push_back(corner_number(facet, k));
        // All of a facet in no other tile is in this one.
        const bool is_own = facet.seam == support::kNone || tree.tile_of(place) == tile;
        result.is_own.push_back(is_own ? 1 : 0);
      }
    }
  }
  return result;
}

void note_first_corners(std::span<const TileFacet> facets, const WeldedTile& tile,
                        FirstCorners& first, SeamCorners& seams) {
  for (std::size_t point = 0; point < tile.first_corner.size(); ++point) {
    if (tile.is_own[point] != 0) {
      first.set(tile.first_corner[point]);
    }
  }
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (std::size_t k = 0; k < 3 && facets[i].seam != support::kNone; ++k) {
      const std::uint32_t point = tile.triangles[i][k];
      if (tile.is_own[point] != 0) {
        seams[3 * std::size_t{facets[i].seam} + k] = tile.first_corner[point];
      }
    }
  }
}

TileMesh tile_mesh(std::span<const TileFacet> facets, WeldedTile tile, const FirstCorners& first,
                   const SeamCorners& seams) {
  const std::size_t points = tile.first_corner.size();
  // A point of another tile is a corner of facets in both.
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (std::size_t k = 0; k < 3 && facets[i].seam != support::kNone; ++k) {
      tile.first_corner[tile.triangles[i][k]] = seams[3 * std::size_t{facets[i].seam} + k];
    }
  }
  std::vector<std::uint32_t> order(points), place(points);
  std::iota(order.begin(), order.end(), 0U);
  if (!std::ranges::is_sorted(tile.first_corner)) {
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return tile.first_corner[i]; });
  }
  TileMesh result;
  result.points.reserve(points);
  result.owns_point.reserve(points);
  for (std::uint32_t i = 0; i < points; ++i) {
    place[order[i]] = i;
    result.points.push_back(static_cast<std::uint32_t>(first.rank(tile.first_corner[order[i]])));
    result.owns_point.push_back(tile.is_own[order[i]]);
  }
  result.mesh.points.resize(points);
  result.owns_face.reserve(facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& corner = tile.triangles[i][k];
      corner = place[corner];
      result.mesh.points[corner] = to_vec3(corner_of(facets[i].corners, k));
    }
    result.owns_face.push_back(result.owns_point[tile.triangles[i][0]]);
  }
  result.mesh.triangles = std::move(tile.triangles);
  return result;
}

}  // namespace dupin::tiles
