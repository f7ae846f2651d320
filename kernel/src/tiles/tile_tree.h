#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// The check of meshes larger than memory (dupin/kernel/tiled_check.h). Space is cut into tiles
/// (tile_tree.h); a facet belongs to all that its box reaches into. What is reported of a mesh is a
/// sum over places, each of which one tile counts: a corner, and what is around it, the tile that
/// the corner is in; an edge the tile of its lower end; a facet that of its first corner; a pair of
/// facets that meet the tile of the lowest corner that their boxes have in common. Each of these
/// tiles has all facets there. Corners are numbered in the order of the whole (first_corners.h), so
/// that a tile (tile_mesh.h), inspected by checking/inspection.h, says the whole's words. Shells
/// are put together from their parts in tiles (shell_parts.h), and whether one is around another is
/// a sum over facets again.
namespace dupin::tiles {

using Place = std::array<float, 3>;

struct PlaceBox {
  Place low, high;
};

/// A partition of space by planes across the axes, which have the side above them.
class TileTree {
 public:
  /// At most so many tiles, with about as many of the sample in each.
  TileTree(std::vector<Place> sample, std::size_t most);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::uint32_t tile_of(const Place& place) const;
  /// Calls visit(tile) for each tile that the closed box has a place of.
  template <class Visit>
  void for_each_tile(const PlaceBox& box, const Visit& visit) const {
    for_each_tile(0, box, visit);
  }

 private:
  /// A leaf has no axis; its tile is in `below`.
  struct Node {
    static constexpr std::uint32_t kLeaf = 3;
    std::uint32_t axis = kLeaf;
    float split = 0;
    std::uint32_t below = 0, above = 0;
  };

  std::uint32_t build(std::span<Place> sample, std::size_t most);

  template <class Visit>
  void for_each_tile(std::uint32_t number, const PlaceBox& box, const Visit& visit) const {
    const Node& node = nodes_[number];
    if (node.axis == Node::kLeaf) {
      visit(node.below);
      return;
    }
    if (box.low[node.axis] < node.split) {
      for_each_tile(node.below, box, visit);
    }
    if (!(box.high[node.axis] < node.split)) {
      for_each_tile(node.above, box, visit);
    }
  }

  std::vector<Node> nodes_;
  std::size_t size_ = 0;
};

}  // namespace dupin::tiles
