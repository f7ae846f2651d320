#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "boxes/box_quad.h"
#include "boxes/box_quantizer.h"
#include "boxes/oriented_box.h"
#include "support/bulk_vector.h"
#include "support/none.h"

namespace dupin::boxes {

/// A balanced tree over boxes, in which each node has four children and each leaf four items.
class BoxTree {
 public:
  static constexpr std::uint32_t kFan = BoxQuad::kSize;

  /// The node `index` of those at a level: leaves are at level 1, the root at the highest. An item
  /// may be named so too, at level 0 and by its place in the tree's order.
  struct Node {
    std::uint32_t level, index;
    friend bool operator==(const Node&, const Node&) = default;
    [[nodiscard]] Node child(std::uint32_t i) const { return {level - 1, kFan * index + i}; }
    [[nodiscard]] Node parent() const { return {level + 1, index / kFan}; }
    [[nodiscard]] bool is_leaf() const { return level == 1; }
  };

  using BoxOf = std::function<Box(std::uint32_t item)>;
  using TriangleOf = std::function<FramedTriangle(std::uint32_t item)>;

  /// The order is kept where neighbours come together, as from any generator of meshes: such trees
  /// are quick to make and better than those in Morton order, which is taken else. Items may belong
  /// to groups other than support::kNone: TreeTraversal, within the tree, leaves out pairs of
  /// one group.
  explicit BoxTree(std::span<const Box> boxes, std::span<const std::uint32_t> groups = {});

  /// The same over triangles that lie in the boxes. Where they are long and slanted, and many boxes
  /// overlap for that, nodes have oriented boxes besides. `triangle(item)` is asked for all whose
  /// box is not nothing.
  BoxTree(std::span<const Box> boxes, const TriangleOf& triangle,
          std::span<const std::uint32_t> groups = {});
  /// The same of boxes that nobody keeps: `box(item)` is asked for whenever a tree is made, by any
  /// threads.
  BoxTree(std::uint32_t size, const BoxOf& box, const TriangleOf& triangle,
          std::span<const std::uint32_t> groups);

  /// Whether `box` overlaps that of some item.
  [[nodiscard]] bool overlaps(const Box& box) const {
    return visit_items(box, nullptr, [](std::uint32_t) { return true; });
  }
  /// Calls visit(item) for every item whose box overlaps `box`.
  template <class Visit>
  void visit(const Box& box, Visit&& visit) const {
    const OrientedBox oriented(box);
    visit_items(box, &oriented, [&](std::uint32_t i) { return visit(order_[i]), false; });
  }
  /// Calls visit(item, its box) for items, until it returns true: all those whose triangle meets
  /// some of those given, which lie in `box`, and others. Whether it did.
  template <class Visit>
  bool visit_until(const Box& box, std::span<const FramedTriangle> triangles, Visit&& visit) const {
    const OrientedBox oriented = oriented_.empty() ? OrientedBox() : OrientedBox(triangles);
    return visit_items(box, &oriented, [&](std::uint32_t i) {
      return visit(order_[i], box_of({0, i}));
    });
  }

  /// The items in the tree's order, kFan to a leaf.
  [[nodiscard]] std::span<const std::uint32_t> items() const { return order_; }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(order_.size()); }
  /// Whether some boxes of nodes lie along axes of their own, and contain nothing but the
  /// triangles.
  [[nodiscard]] bool is_oriented() const { return !oriented_.empty(); }

  /// Makes the box of `item` contain `box` as well, and those around it the triangle therein.
  /// O(log n).
  void grow(std::uint32_t item, const Box& box, const FramedTriangle& triangle);

 private:
  friend class TreeTraversal;
  BoxTree() = default;
  BoxTree(std::vector<std::uint32_t> order, const BoxOf& box);
  [[nodiscard]] static std::vector<std::uint32_t> given_order(std::size_t size);
  [[nodiscard]] std::vector<std::uint32_t> morton_order() const;
  void set_groups(std::span<const std::uint32_t> groups);
  [[nodiscard]] Node root() const { return {height_, 0}; }
  /// Where what nodes have is found in arrays.
  [[nodiscard]] std::uint32_t number(const Node& node) const {
    return first_[node.level] + node.index;
  }
  /// The number of nodes, or items, at a level.
  [[nodiscard]] std::uint32_t count(std::uint32_t level) const {
    return level == 0 ? size() : first_[level + 1] - first_[level];
  }
  /// The boxes of its children, or items.
  [[nodiscard]] const BoxQuad& quad(const Node& node) const { return quads_[number(node)]; }
  [[nodiscard]] Box box_of(const Node& node) const {
    return node.level == height_ ? root_ : quad(node.parent())[node.index % kFan];
  }
  [[nodiscard]] bool of_one_group(const Node& node, const Node& other) const {
    if (groups_.empty()) {
      return false;
    }
    const std::uint32_t group = groups_[number(node)];
    return group != support::kNone && group == groups_[number(other)];
  }
  [[nodiscard]] bool items_of_one_group(std::uint32_t i, std::uint32_t k) const {
    return !item_groups_.empty() && item_groups_[i] != support::kNone &&
           item_groups_[i] == item_groups_[k];
  }
  [[nodiscard]] bool is_slanted(const Node& node) const {
    return !oriented_.empty() && slanted_[number(node)] != 0;
  }
  /// Calls visit(place of an item) for those whose boxes overlap `box`, below nodes whose oriented
  /// boxes overlap `oriented`, if given, until it is true; whether it was.
  template <class Visit>
  bool visit_items(const Box& box, const OrientedBox* oriented, Visit&& visit) const;
  /// Whether the oriented boxes of nodes whose boxes overlap are not apart.
  [[nodiscard]] bool may_meet(const Node& node, const BoxTree& other,
                              const Node& other_node) const {
    return (!is_slanted(node) && !other.is_slanted(other_node)) ||
           !oriented_apart(node, other, other_node);
  }
  [[nodiscard]] bool oriented_apart(const Node& node, const BoxTree& other,
                                    const Node& other_node) const;
  /// What a leaf costs: nodes that it meets, leaves more than others, not those of one group.
  [[nodiscard]] double crowding() const;
  /// Leaves of meshes in good order cost 60 to 350, which grows with the tree's height.
  static constexpr double kCrowded = 700;
  /// Few items may be picked here and there, and are quick to put in order.
  static constexpr std::uint32_t kFew = 1 << 16;
  static constexpr double kCrowdedFew = 100;
  /// Makes oriented boxes if the tree is crowded without them and triangles are known. Returns the
  /// crowding.
  double orient_if_crowded(const TriangleOf& triangle);
  void orient_inner_node(const Node& node);
  void orient_inner_nodes();
  void set_oriented(const Node& node, const OrientedBox& box);

  static constexpr std::uint32_t kMostLevels = 20;  // more than any tree over 2^32 items has
  std::vector<std::uint32_t> order_, position_;     // the latter once an item grows
  std::uint32_t height_ = 0;
  std::array<std::uint32_t, kMostLevels> first_{};  // number of the first node at each level
  support::BulkVector<BoxQuad> quads_;
  Box root_;
  // Of nodes, and whether it is much smaller than the other box; empty if it never is.
  std::vector<OrientedBox> oriented_;
  std::vector<std::uint8_t> slanted_;
  std::vector<std::uint32_t> groups_;       // of all items below a node; empty if there are none
  std::vector<std::uint32_t> item_groups_;  // in the order of the tree
};

template <class Visit>
bool BoxTree::visit_items(const Box& box, const OrientedBox* oriented, Visit&& visit) const {
  std::array<Node, kMostLevels * kFan> stack;
  std::size_t depth = 0;
  stack[depth++] = root();
  const bool by_axes = oriented != nullptr && !oriented_.empty();
  while (depth > 0) {
    const Node node = stack[--depth];
    if (by_axes && oriented_[number(node)].apart(*oriented)) {
      continue;
    }
    const unsigned meeting = quad(node).overlapping(box);
    if (node.is_leaf()) {
      for (unsigned bits = meeting; bits != 0; bits &= bits - 1) {
        if (visit(node.child(static_cast<std::uint32_t>(std::countr_zero(bits))).index)) {
          return true;
        }
      }
      continue;
    }
    for (std::uint32_t i = kFan; i-- > 0;) {  // the first is visited first
      stack[depth] = node.child(i);
      depth += meeting >> i & 1;
    }
  }
  return false;
}

}  // namespace dupin::boxes
