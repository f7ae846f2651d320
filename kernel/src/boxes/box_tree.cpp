#include "boxes/box_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <tbb/parallel_sort.h>

#include "support/blocks.h"

namespace dupin::boxes {
namespace {

struct Keyed {
  std::uint64_t key;
  std::uint32_t item;
  auto operator<=>(const Keyed&) const = default;
};

/// The low 21 bits of `value`, two zeros between each two.
std::uint64_t spread(std::uint64_t value) {
  value &= 0x1fffff;
  value = (value | value << 32) & 0x1f00000000ffff;
  value = (value | value << 16) & 0x1f0000ff0000ff;
  value = (value | value << 8) & 0x100f00f00f00f00f;
  value = (value | value << 4) & 0x10c30c30c30c30c3;
  return (value | value << 2) & 0x1249249249249249;
}

/// Interleaved bits of the box's centre, whose coordinates lie in [-1, 1] (see BoxQuantizer).
std::uint64_t morton_key(const Box& box) {
  std::uint64_t key = 0;
  if (box.is_nothing()) {
    return key;  // nothing has no centre
  }
  for (int k = 0; k < 3; ++k) {
    const float centre = (box.low[k] + box.high[k]) / 2;
    const float cell = (std::clamp(centre, -1.0F, 1.0F) + 1) * 0x0.fffffp20F;
    key |= spread(static_cast<std::uint64_t>(cell)) << k;
  }
  return key;
}

}  // namespace

std::vector<std::uint32_t> BoxTree::given_order(std::size_t size) {
  std::vector<std::uint32_t> order(size);
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

BoxTree BoxTree::reordered() const {
  std::vector<Keyed> keyed(size());
  support::for_each_block(size(), [&](const support::Block& block) {
    for (auto i = static_cast<std::uint32_t>(block.begin); i < block.end; ++i) {
      keyed[i] = {morton_key(boxes_[i]), i};
    }
  });
  tbb::parallel_sort(keyed.begin(), keyed.end());
  std::vector<std::uint32_t> order(size());
  support::BulkVector<Box> boxes(size());
  for (std::uint32_t i = 0; i < size(); ++i) {
    order[i] = order_[keyed[i].item];
    boxes[i] = boxes_[keyed[i].item];
  }
  return {std::move(order), std::move(boxes)};
}

BoxTree::BoxTree(std::span<const Box> boxes, std::span<const std::uint32_t> groups)
    : BoxTree(given_order(boxes.size()), support::BulkVector<Box>(boxes.begin(), boxes.end())) {
  set_groups(groups);
  if (const double crowded = crowding(); crowded > kCrowded) {
    BoxTree other = reordered();
    other.set_groups(groups);
    if (other.crowding() < crowded) {
      *this = std::move(other);
    }
  }
}

BoxTree::BoxTree(std::vector<std::uint32_t> order, support::BulkVector<Box>&& boxes)
    : order_(std::move(order)),
      boxes_(std::move(boxes)),
      leaves_(std::bit_ceil(std::max(1U, leaf_count()))),
      nodes_(2 * std::size_t{leaves_}) {
  support::for_each_block(leaves_, [&](const support::Block& block) {
    for (auto leaf = static_cast<std::uint32_t>(block.begin); leaf < block.end; ++leaf) {
      Box node = Box::nothing();
      for (std::uint32_t i = leaf * kLeafSize; leaf < leaf_count() && i < leaf_end(leaf); ++i) {
        node.join(boxes_[i]);
      }
      nodes_[leaves_ + leaf] = node;
    }
  });
  nodes_[0] = Box::nothing();
  for (std::size_t node = leaves_ - 1; node > 0; --node) {
    nodes_[node] = nodes_[2 * node];
    nodes_[node].join(nodes_[2 * node + 1]);
  }
}

void BoxTree::set_oriented(std::uint32_t node, const OrientedBox& box) {
  // Below that, the other box alone is cheaper.
  constexpr float kSlanted = 4;
  const OrientedBox upright(nodes_[node]);
  slanted_[node] = kSlanted * box.surface() < upright.surface() ? 1 : 0;
  oriented_[node] = slanted_[node] != 0 ? box : upright;
}

void BoxTree::orient_leaf(std::uint32_t leaf, std::span<const FramedTriangle> triangles) {
  if (!triangles.empty()) {
    set_oriented(leaves_ + leaf, OrientedBox(triangles));
  }
}

void BoxTree::orient_inner_nodes() {
  if (std::ranges::none_of(slanted_, [](std::uint8_t slanted) { return slanted != 0; })) {
    oriented_ = {};
    return;
  }
  for (std::uint32_t node = leaves_ - 1; node > 0; --node) {
    const std::uint32_t left = 2 * node, right = left + 1;
    if (nodes_[left].is_nothing() || nodes_[right].is_nothing()) {
      const std::uint32_t only = nodes_[left].is_nothing() ? right : left;
      oriented_[node] = oriented_[only];
      slanted_[node] = slanted_[only];
    } else if (slanted_[left] == 0 && slanted_[right] == 0) {
      oriented_[node] = OrientedBox(nodes_[node]);
    } else {
      set_oriented(node, OrientedBox(oriented_[left], oriented_[right]));
    }
  }
}

bool BoxTree::overlap(std::uint32_t node, const BoxTree& other, std::uint32_t other_node) const {
  if (!nodes_[node].overlaps(other.nodes_[other_node])) {
    return false;
  }
  const auto slanted = [](const BoxTree& tree, std::uint32_t i) {
    return !tree.oriented_.empty() && tree.slanted_[i] != 0;
  };
  if (!slanted(*this, node) && !slanted(other, other_node)) {
    return true;
  }
  const auto oriented = [](const BoxTree& tree, std::uint32_t i) {
    return tree.oriented_.empty() ? OrientedBox(tree.nodes_[i]) : tree.oriented_[i];
  };
  return !oriented(*this, node).apart(oriented(other, other_node));
}

bool BoxTree::overlaps(const Box& box) const {
  return visit_leaves(
      [&](std::uint32_t node) { return box.overlaps(nodes_[node]); },
      [&](std::uint32_t leaf) {
        const auto items =
            std::span(boxes_).subspan(leaf * kLeafSize, leaf_end(leaf) - leaf * kLeafSize);
        return std::ranges::any_of(items, [&](const Box& item) { return box.overlaps(item); });
      });
}

double BoxTree::crowding() const {
  constexpr std::uint32_t kSamples = 64, kMost = 1 << 14, kLeaf = 8;  // times an inner node
  const std::uint32_t count = std::min(kSamples, leaf_count());
  std::uint32_t met = 0;
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto leaf = leaves_ + static_cast<std::uint32_t>(std::uint64_t{i} * leaf_count() / count);
    nodes.assign({1});
    while (!nodes.empty() && met < count * kMost) {
      const std::uint32_t node = nodes.back();
      nodes.pop_back();
      ++met;
      if (node == leaf || of_one_group(leaf, node) || !overlap(leaf, *this, node)) {
        continue;
      }
      if (node < leaves_) {
        nodes.insert(nodes.end(), {2 * node, 2 * node + 1});
      } else {
        met += kLeaf;
      }
    }
  }
  return count == 0 ? 0 : static_cast<double>(met) / count;
}

void BoxTree::set_groups(std::span<const std::uint32_t> groups) {
  if (groups.empty()) {
    return;
  }
  item_groups_.resize(size());
  for (std::uint32_t i = 0; i < size(); ++i) {
    item_groups_[i] = groups[order_[i]];
  }
  groups_.assign(nodes_.size(), support::kNone);
  for (std::uint32_t leaf = 0; leaf < leaf_count(); ++leaf) {
    const std::uint32_t first = leaf * kLeafSize;
    std::uint32_t& group = groups_[leaves_ + leaf];
    group = item_groups_[first];
    for (std::uint32_t i = first; i < leaf_end(leaf); ++i) {
      group = item_groups_[i] == group ? group : support::kNone;
    }
  }
  for (std::size_t node = leaves_ - 1; node > 0; --node) {
    groups_[node] = groups_[2 * node] == groups_[2 * node + 1] ? groups_[2 * node] : support::kNone;
  }
}

void BoxTree::grow(std::uint32_t item, const Box& box, const FramedTriangle& triangle) {
  if (position_.empty()) {
    position_.resize(size());
    for (std::uint32_t i = 0; i < size(); ++i) {
      position_[order_[i]] = i;
    }
  }
  const std::uint32_t at = position_[item];
  boxes_[at].join(box);
  for (std::uint32_t node = leaves_ + at / kLeafSize; node > 0; node /= 2) {
    const bool was_nothing = nodes_[node].is_nothing();
    nodes_[node].join(box);
    if (!oriented_.empty()) {
      if (was_nothing) {
        oriented_[node] = OrientedBox({&triangle, 1});
      } else {
        oriented_[node].include(triangle);
      }
    }
  }
}

}  // namespace dupin::boxes
