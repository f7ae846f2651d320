#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::detail {

/// An axis-parallel box in the single precision coordinates of a BoxFrame.
struct Box {
  std::array<float, 3> low, high;

  [[nodiscard]] bool overlaps(const Box& other) const {
    return (low[0] <= other.high[0]) & (other.low[0] <= high[0]) & (low[1] <= other.high[1]) &
           (other.low[1] <= high[1]) & (low[2] <= other.high[2]) & (other.low[2] <= high[2]);
  }
  [[nodiscard]] bool contains(const Box& other) const;
  /// Makes the box contain `other` too.
  void join(const Box& other);
  /// Contains nothing, overlaps nothing.
  [[nodiscard]] static Box nothing();
};

/// Maps coordinates to floats about the middle of a point set. The map is monotone per coordinate,
/// so boxes that overlap do so after it as well: no outward rounding is needed.
class BoxFrame {
 public:
  explicit BoxFrame(std::span<const Vec3> points);
  [[nodiscard]] Box around(const Vec3& a, const Vec3& b, const Vec3& c) const;

 private:
  [[nodiscard]] float map(double coordinate, int axis) const {
    return static_cast<float>((coordinate - middle_[axis]) * scale_);
  }
  Vec3 middle_;
  double scale_;  // a power of two
};

/// A balanced binary tree over boxes in Morton order of their centres, four to a leaf.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Box> boxes);

  /// Calls visit(item) for every item whose box overlaps `box`.
  template <class Visit>
  void visit(const Box& box, Visit&& visit) const {
    visit_below(1, box, visit);
  }
  /// Calls visit(item) for every item that stands after `position` and overlaps its box: over all
  /// positions, every overlapping pair once.
  template <class Visit>
  void visit_after(std::uint32_t position, Visit&& visit) const;

  /// The item at a position of the tree's order; positions run from 0 to the number of boxes.
  [[nodiscard]] std::uint32_t item(std::uint32_t position) const { return order_[position]; }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(order_.size()); }

  /// Makes the box of `item` contain `box` as well. O(log n).
  void grow(std::uint32_t item, const Box& box);

 private:
  static constexpr std::uint32_t kLeafSize = 4;

  template <class Visit>
  void visit_below(std::uint32_t root, const Box& box, Visit&& visit) const;

  std::vector<std::uint32_t> order_, position_;
  std::vector<Box> boxes_;  // in the order of the tree
  std::uint32_t leaves_;    // a power of two
  std::vector<Box> nodes_;  // node i has the children 2i and 2i + 1; the leaves come last
};

template <class Visit>
void BoxTree::visit_below(std::uint32_t root, const Box& box, Visit&& visit) const {
  if (!box.overlaps(nodes_[root])) {
    return;
  }
  std::array<std::uint32_t, 40> stack;  // deeper than any tree over 2^32 items
  std::size_t depth = 0;
  stack[depth++] = root;
  while (depth > 0) {
    const std::uint32_t node = stack[--depth];
    if (node < leaves_) {
      for (const std::uint32_t child : {2 * node + 1, 2 * node}) {
        stack[depth] = child;
        depth += box.overlaps(nodes_[child]) ? 1 : 0;
      }
      continue;
    }
    const std::uint32_t first = (node - leaves_) * kLeafSize;
    for (std::uint32_t i = first; i < std::min(first + kLeafSize, size()); ++i) {
      if (box.overlaps(boxes_[i])) {
        visit(order_[i]);
      }
    }
  }
}

template <class Visit>
void BoxTree::visit_after(std::uint32_t position, Visit&& visit) const {
  const Box& box = boxes_[position];
  const std::uint32_t leaf = position / kLeafSize;
  for (std::uint32_t i = position + 1; i < std::min((leaf + 1) * kLeafSize, size()); ++i) {
    if (box.overlaps(boxes_[i])) {
      visit(order_[i]);
    }
  }
  for (std::uint32_t node = leaves_ + leaf; node > 1; node /= 2) {
    if (node % 2 == 0) {
      visit_below(node + 1, box, visit);
    }
  }
}

}  // namespace dupin::detail
