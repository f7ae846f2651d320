#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "boxes/box_quantizer.h"
#include "boxes/oriented_box.h"
#include "support/blocks.h"
#include "support/bulk_vector.h"
#include "support/none.h"

namespace dupin::boxes {

/// A balanced binary tree over boxes, four to a leaf.
class BoxTree {
 public:
  static constexpr std::uint32_t kLeafSize = 4;

  /// The order is kept where neighbours come together, as from any generator of meshes: such trees
  /// are quick to make and better than those in Morton order, which is taken else. Items may belong
  /// to groups other than support::kNone: TreeTraversal, within the tree, leaves out pairs of
  /// one group.
  explicit BoxTree(std::span<const Box> boxes, std::span<const std::uint32_t> groups = {});

  /// The same over triangles that lie in the boxes. Where they are long and slanted, and many boxes
  /// overlap for that, nodes have oriented boxes besides. `triangle(item)` is asked for all whose
  /// box is not nothing.
  template <class Triangles>
  BoxTree(support::BulkVector<Box> boxes, Triangles&& triangle,
          std::span<const std::uint32_t> groups = {});

  /// Whether `box` overlaps that of some item.
  [[nodiscard]] bool overlaps(const Box& box) const;
  /// Calls visit(item) for every item whose box overlaps `box`.
  template <class Visit>
  void visit(const Box& box, Visit&& visit) const {
    visit_items(box, OrientedBox(box),
                [&](std::uint32_t item, const Box&) { return visit(item), false; });
  }
  /// Calls visit(item, its box) for items, until it returns true: all those whose triangle meets
  /// some of those given, which lie in `box`, and others. Whether it did.
  template <class Visit>
  bool visit_until(const Box& box, std::span<const FramedTriangle> triangles, Visit&& visit) const {
    return visit_items(box, oriented_.empty() ? OrientedBox() : OrientedBox(triangles), visit);
  }

  /// The items in the tree's order, kLeafSize to a leaf.
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
  /// Over boxes in this order.
  BoxTree(std::vector<std::uint32_t> order, support::BulkVector<Box>&& boxes);
  [[nodiscard]] static std::vector<std::uint32_t> given_order(std::size_t size);
  /// The same items in Morton order.
  [[nodiscard]] BoxTree reordered() const;
  void set_groups(std::span<const std::uint32_t> groups);
  [[nodiscard]] bool of_one_group(std::uint32_t node, std::uint32_t other) const {
    return !groups_.empty() && groups_[node] != support::kNone && groups_[node] == groups_[other];
  }
  [[nodiscard]] bool items_of_one_group(std::uint32_t i, std::uint32_t k) const {
    return !item_groups_.empty() && item_groups_[i] != support::kNone &&
           item_groups_[i] == item_groups_[k];
  }
  [[nodiscard]] std::uint32_t leaf_count() const { return (size() + kLeafSize - 1) / kLeafSize; }
  [[nodiscard]] std::uint32_t leaf_end(std::uint32_t leaf) const {
    return std::min((leaf + 1) * kLeafSize, size());
  }
  /// What is sought among nodes.
  struct Target {
    const Box& box;
    const OrientedBox& oriented;
  };
  /// Calls visit(leaf) for leaves below nodes where meets(node), until it is true; whether it was.
  template <class Meets, class Visit>
  bool visit_leaves(Meets&& meets, Visit&& visit) const;
  template <class Visit>
  bool visit_items(const Box& box, const OrientedBox& oriented, Visit&& visit) const;
  [[nodiscard]] bool overlap(std::uint32_t node, const Target& target) const {
    return target.box.overlaps(nodes_[node]) &&
           (oriented_.empty() || !oriented_[node].apart(target.oriented));
  }
  [[nodiscard]] bool overlap(std::uint32_t node, const BoxTree& other,
                             std::uint32_t other_node) const;
  /// What a leaf costs: nodes that it meets, leaves more than others, not those of one group.
  [[nodiscard]] double crowding() const;
  /// Leaves of meshes in good order cost 70 to 350, which grows with the tree's height.
  static constexpr double kCrowded = 1000;
  /// Few items may be picked here and there, and are quick to put in order.
  static constexpr std::uint32_t kFew = 1 << 16;
  static constexpr double kCrowdedFew = 100;
  /// Makes oriented boxes if the tree is crowded without them. Returns the crowding.
  template <class Triangles>
  double orient_if_crowded(Triangles&& triangle);
  void orient_leaf(std::uint32_t leaf, std::span<const FramedTriangle> triangles);
  void orient_inner_nodes();
  void set_oriented(std::uint32_t node, const OrientedBox& box);

  std::vector<std::uint32_t> order_, position_;  // the latter once an item grows
  support::BulkVector<Box> boxes_;               // in the order of the tree
  std::uint32_t leaves_;                         // a power of two
  support::BulkVector<Box> nodes_;  // node i has the children 2i and 2i + 1; the leaves come last
  // Of nodes, and whether it is much smaller than the other box; empty if it never is.
  std::vector<OrientedBox> oriented_;
  std::vector<std::uint8_t> slanted_;
  std::vector<std::uint32_t> groups_;       // of all items below a node; empty if there are none
  std::vector<std::uint32_t> item_groups_;  // in the order of the tree
};

template <class Triangles>
BoxTree::BoxTree(support::BulkVector<Box> boxes, Triangles&& triangle,
                 std::span<const std::uint32_t> groups)
    : BoxTree(given_order(boxes.size()), std::move(boxes)) {
  set_groups(groups);
  const double crowded = orient_if_crowded(triangle);
  if (crowded > (size() <= kFew ? kCrowdedFew : kCrowded)) {
    BoxTree other = reordered();
    other.set_groups(groups);
    if (other.orient_if_crowded(triangle) < crowded) {
      *this = std::move(other);
    }
  }
}

template <class Triangles>
double BoxTree::orient_if_crowded(Triangles&& triangle) {
  if (const double crowded = crowding(); crowded <= kCrowded) {
    return crowded;
  }
  oriented_.resize(nodes_.size());
  slanted_.resize(nodes_.size());
  constexpr std::size_t kLeaves = 64;
  const auto orient = [&](const support::Block& block) {
    for (auto leaf = static_cast<std::uint32_t>(block.begin); leaf < block.end; ++leaf) {
      std::array<FramedTriangle, kLeafSize> triangles;
      std::size_t count = 0;
      for (std::uint32_t i = leaf * kLeafSize; i < leaf_end(leaf); ++i) {
        if (!boxes_[i].is_nothing()) {
          triangles[count++] = triangle(order_[i]);
        }
      }
      orient_leaf(leaf, std::span(triangles).first(count));
    }
  };
  support::for_each_block(leaf_count(), orient, kLeaves);
  orient_inner_nodes();
  return crowding();
}

template <class Visit>
bool BoxTree::visit_items(const Box& box, const OrientedBox& oriented, Visit&& visit) const {
  const Target target{box, oriented};
  return visit_leaves([&](std::uint32_t node) { return overlap(node, target); },
                      [&](std::uint32_t leaf) {
                        for (std::uint32_t i = leaf * kLeafSize; i < leaf_end(leaf); ++i) {
                          if (box.overlaps(boxes_[i]) && visit(order_[i], boxes_[i])) {
                            return true;
                          }
                        }
                        return false;
                      });
}

template <class Meets, class Visit>
bool BoxTree::visit_leaves(Meets&& meets, Visit&& visit) const {
  if (!meets(1)) {
    return false;
  }
  std::array<std::uint32_t, 40> stack;  // deeper than any tree over 2^32 items
  std::size_t depth = 0;
  stack[depth++] = 1;
  while (depth > 0) {
    const std::uint32_t node = stack[--depth];
    if (node >= leaves_) {
      if (visit(node - leaves_)) {
        return true;
      }
      continue;
    }
    for (const std::uint32_t child : {2 * node + 1, 2 * node}) {
      stack[depth] = child;
      depth += meets(child) ? 1 : 0;
    }
  }
  return false;
}

}  // namespace dupin::boxes
