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

std::vector<std::uint32_t> BoxTree::morton_order() const {
  std::vector<Keyed> keyed(size());
  support::for_each_block(size(), [&](const support::Block& block) {
    for (auto i = static_cast<std::uint32_t>(block.begin); i < block.end; ++i) {
      keyed[i] = {morton_key(box_of({0, i})), i};
    }
  });
  tbb::parallel_sort(keyed.begin(), keyed.end());
  std::vector<std::uint32_t> order(size());
  std::ranges::transform(keyed, order.begin(),
                         [this](const Keyed& place) { return order_[place.item]; });
  return order;
}

BoxTree::BoxTree(std::span<const Box> boxes, std::span<const std::uint32_t> groups)
    : BoxTree(boxes, nullptr, groups) {}

BoxTree::BoxTree(std::span<const Box> boxes, const TriangleOf& triangle,
                 std::span<const std::uint32_t> groups)
    : BoxTree(
          static_cast<std::uint32_t>(boxes.size()), [&](std::uint32_t i) { return boxes[i]; },
          triangle, groups) {}

BoxTree::BoxTree(std::uint32_t size, const BoxOf& box, const TriangleOf& triangle,
                 std::span<const std::uint32_t> groups) {
  const auto make = [&](std::vector<std::uint32_t> order, const TriangleOf& slanted) {
    *this = BoxTree();  // first the room of another one
    *this = BoxTree(std::move(order), box);
    set_groups(groups);
    return orient_if_crowded(slanted);
  };
  const double limit = triangle && size <= kFew ? kCrowdedFew : kCrowded;
  double given = make(given_order(size), nullptr);
  if (given <= limit) {
    return;
  }
  std::vector<std::uint32_t> order = morton_order();
  if (triangle && given > kCrowded) {
    // An order in which few overlap costs less than oriented boxes, which may do so in the other.
    if (make(order, nullptr) <= kCrowded) {
      return;
    }
    given = make(given_order(size), triangle);
    if (given <= limit) {
      return;
    }
  }
  if (make(std::move(order), triangle) >= given) {
    make(given_order(size), triangle);
  }
}

BoxTree::BoxTree(std::vector<std::uint32_t> order, const BoxOf& box) : order_(std::move(order)) {
  std::uint32_t nodes = size();
  do {
    nodes = std::max(1U, nodes / kFan + (nodes % kFan == 0 ? 0 : 1));
    ++height_;
    first_[height_ + 1] = first_[height_] + nodes;
  } while (nodes > 1);
  quads_.resize(first_[height_ + 1]);
  for (std::uint32_t level = 1; level <= height_; ++level) {
    support::for_each_block(count(level), [&](const support::Block& block) {
      for (auto index = static_cast<std::uint32_t>(block.begin); index < block.end; ++index) {
        BoxQuad children;
        const std::uint32_t end = std::min(kFan * (index + 1), count(level - 1));
        for (std::uint32_t i = kFan * index; i < end; ++i) {
          children.set(i % kFan, level == 1 ? box(order_[i]) : quad({level - 1, i}).joined());
        }
        quads_[number({level, index})] = children;
      }
    });
  }
  root_ = quad(root()).joined();
}

double BoxTree::orient_if_crowded(const TriangleOf& triangle) {
  if (const double crowded = crowding(); crowded <= kCrowded || !triangle) {
    return crowded;
  }
  oriented_.resize(quads_.size());
  slanted_.resize(quads_.size());
  constexpr std::size_t kLeaves = 64;
  const auto orient = [&](const support::Block& block) {
    for (auto leaf = static_cast<std::uint32_t>(block.begin); leaf < block.end; ++leaf) {
      std::array<FramedTriangle, kFan> triangles;
      std::size_t found = 0;
      for (std::uint32_t i = kFan * leaf; i < std::min(kFan * (leaf + 1), size()); ++i) {
        if (!box_of({0, i}).is_nothing()) {
          triangles[found++] = triangle(order_[i]);
        }
      }
      if (found > 0) {
        set_oriented({1, leaf}, OrientedBox(std::span(triangles).first(found)));
      }
    }
  };
  support::for_each_block(count(1), orient, kLeaves);
  orient_inner_nodes();
  return crowding();
}

void BoxTree::set_oriented(const Node& node, const OrientedBox& box) {
  // Below that, the other box alone is cheaper.
  constexpr float kSlanted = 4;
  const OrientedBox upright(box_of(node));
  const bool is_smaller = kSlanted * box.surface() < upright.surface();
  slanted_[number(node)] = is_smaller ? 1 : 0;
  oriented_[number(node)] = is_smaller ? box : upright;
}

void BoxTree::orient_inner_node(const Node& node) {
  std::array<Node, kFan> children;
  std::size_t found = 0;
  bool slanted = false;
  for (std::uint32_t i = 0; i < kFan; ++i) {
    if (!quad(node)[i].is_nothing()) {
      children[found++] = node.child(i);
      slanted = slanted || is_slanted(node.child(i));
    }
  }
  if (found == 1) {
    oriented_[number(node)] = oriented_[number(children[0])];
    slanted_[number(node)] = slanted_[number(children[0])];
  } else if (slanted) {
    OrientedBox all = oriented_[number(children[0])];
    for (std::size_t i = 1; i < found; ++i) {
      all = OrientedBox(all, oriented_[number(children[i])]);
    }
    set_oriented(node, all);
  } else if (found > 1) {
    oriented_[number(node)] = OrientedBox(box_of(node));
  }
}

void BoxTree::orient_inner_nodes() {
  if (std::ranges::none_of(slanted_, [](std::uint8_t slanted) { return slanted != 0; })) {
    support::release(oriented_);
    return;
  }
  for (std::uint32_t level = 2; level <= height_; ++level) {
    support::for_each_block(count(level), [&](const support::Block& block) {
      for (auto index = static_cast<std::uint32_t>(block.begin); index < block.end; ++index) {
        orient_inner_node({level, index});
      }
    });
  }
}

bool BoxTree::oriented_apart(const Node& node, const BoxTree& other, const Node& other_node) const {
  const auto oriented = [](const BoxTree& tree, const Node& i) {
    return tree.oriented_.empty() ? OrientedBox(tree.box_of(i)) : tree.oriented_[tree.number(i)];
  };
  return oriented(*this, node).apart(oriented(other, other_node));
}

double BoxTree::crowding() const {
  constexpr std::uint32_t kSamples = 64, kMost = 1 << 14, kLeaf = 8;  // times an inner node
  const std::uint32_t samples = size() == 0 ? 0 : std::min(kSamples, count(1));
  std::uint32_t met = 0;
  std::vector<Node> nodes;
  for (std::uint32_t i = 0; i < samples; ++i) {
    const Node leaf{1, static_cast<std::uint32_t>(std::uint64_t{i} * count(1) / samples)};
    const Box box = box_of(leaf);
    nodes.assign({root()});
    while (!nodes.empty() && met < samples * kMost) {
      const Node node = nodes.back();
      nodes.pop_back();
      if (node == leaf || of_one_group(leaf, node) || !may_meet(leaf, *this, node)) {
        continue;
      }
      if (node.is_leaf()) {
        met += kLeaf;
        continue;
      }
      met += kFan;
      const unsigned meeting = quad(node).overlapping(box);
      for (std::uint32_t k = 0; k < kFan; ++k) {
        if ((meeting >> k & 1) != 0) {
          nodes.push_back(node.child(k));
        }
      }
    }
  }
  return samples == 0 ? 0 : static_cast<double>(met) / samples;
}

void BoxTree::set_groups(std::span<const std::uint32_t> groups) {
  if (groups.empty()) {
    return;
  }
  item_groups_.resize(size());
  for (std::uint32_t i = 0; i < size(); ++i) {
    item_groups_[i] = groups[order_[i]];
  }
  groups_.assign(quads_.size(), support::kNone);
  for (std::uint32_t level = 1; level <= height_; ++level) {
    for (std::uint32_t index = 0; index < count(level); ++index) {
      const auto group_below = [&](std::uint32_t i) {
        return level == 1 ? item_groups_[i] : groups_[number({level - 1, i})];
      };
      const std::uint32_t end = std::min(kFan * (index + 1), count(level - 1));
      std::uint32_t& group = groups_[number({level, index})];
      group = kFan * index < end ? group_below(kFan * index) : support::kNone;
      for (std::uint32_t i = kFan * index; i < end; ++i) {
        group = group_below(i) == group ? group : support::kNone;
      }
    }
  }
}

void BoxTree::grow(std::uint32_t item, const Box& box, const FramedTriangle& triangle) {
  if (position_.empty()) {
    position_.resize(size());
    for (std::uint32_t i = 0; i < size(); ++i) {
      position_[order_[i]] = i;
    }
  }
  for (Node node{0, position_[item]};; node = node.parent()) {
    Box grown = box_of(node);
    const bool was_nothing = grown.is_nothing();
    grown.join(box);
    if (node.level > 0 && !oriented_.empty()) {
      if (was_nothing) {
        oriented_[number(node)] = OrientedBox({&triangle, 1});
      } else {
        oriented_[number(node)].include(triangle);
      }
    }
    if (node == root()) {
      root_ = grown;
      return;
    }
    quads_[number(node.parent())].set(node.index % kFan, grown);
  }
}

}  // namespace dupin::boxes
