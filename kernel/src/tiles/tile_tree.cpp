#include "tiles/tile_tree.h"

#include <algorithm>

namespace dupin::tiles {

TileTree::TileTree(std::vector<Place> sample, std::size_t most) { build(sample, most); }

std::uint32_t TileTree::tile_of(const Place& place) const {
  const Node* node = nodes_.data();
  while (node->axis != Node::kLeaf) {
    node = &nodes_[place[node->axis] < node->split ? node->below : node->above];
  }
  return node->below;
}

std::uint32_t TileTree::build(std::span<Place> sample, std::size_t most) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  std::uint32_t axis = 0;
  double extent = 0;
  for (std::uint32_t k = 0; k < 3 && most > 1 && !sample.empty(); ++k) {
    const auto [low, high] =
        std::ranges::minmax(sample, {}, [k](const Place& place) { return place[k]; });
    if (const double own = double(high[k]) - double(low[k]); own > extent) {
      extent = own;
      axis = k;
    }
  }
  if (!(extent > 0)) {
    nodes_[number].below = static_cast<std::uint32_t>(size_++);
    return number;
  }
  const auto along = [axis](const Place& place) { return place[axis]; };
  const std::size_t most_below = most / 2;
  const auto middle = sample.begin() + std::ptrdiff_t(sample.size() * most_below / most);
  std::ranges::nth_element(sample, middle, {}, along);
  float split = along(*middle);
  const float lowest = along(std::ranges::min(sample, {}, along));
  if (split == lowest) {  // the next one, so that there is something below it
    split = along(std::ranges::max(sample, {}, along));
    for (const Place& place : sample) {
      split = place[axis] > lowest ? std::min(split, place[axis]) : split;
    }
  }
  const auto above = std::partition(sample.begin(), sample.end(),
                                    [&](const Place& place) { return along(place) < split; });
  const auto count = static_cast<std::size_t>(above - sample.begin());
  const std::uint32_t below_node = build(sample.first(count), most_below);
  const std::uint32_t above_node = build(sample.subspan(count), most - most_below);
  nodes_[number] = {axis, split, below_node, above_node};
  return number;
}

}  // namespace dupin::tiles
