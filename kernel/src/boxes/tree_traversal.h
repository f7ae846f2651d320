#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "boxes/box_tree.h"

namespace dupin::boxes {

/// Descends two trees, or one against itself, at once: what far nodes decide is decided once for
/// all that is below them.
class TreeTraversal {
 public:
  /// Nodes of the one and of the other tree; within one tree, a node and itself stand for the pairs
  /// of items below it.
  struct Nodes {
    BoxTree::Node one, other;
    friend bool operator==(const Nodes&, const Nodes&) = default;
  };

  explicit TreeTraversal(const BoxTree& tree) : one_(tree), other_(tree) {}
  TreeTraversal(const BoxTree& one, const BoxTree& other) : one_(one), other_(other) {}

  /// Some more pairs of nodes than `count`, unless there are fewer leaves, which together stand for
  /// all pairs of items.
  [[nodiscard]] std::vector<Nodes> tasks(std::size_t count) const;

  /// Calls visit(i, k) for items below the nodes, by their places in the trees' order: once for
  /// every pair of boxes that overlap, or of triangles that meet. Pairs with the same i come in
  /// runs.
  template <class Visit>
  void visit(const Nodes& nodes, Visit&& visit) const {
    std::array<Nodes, 512> stack;  // each step of at most 32 down adds fifteen at most
    std::size_t depth = 0;
    stack[depth++] = nodes;
    while (depth > 0) {
      const Nodes at = stack[--depth];
      if (at.one.is_leaf() && at.other.is_leaf()) {
        compare(at, visit);
      } else {
        expand(at, [&](const Nodes& below) { stack[depth++] = below; });
      }
    }
  }
  /// The same for all items of the trees.
  template <class Visit>
  void visit(Visit&& visit) const {
    if (within_one() || one_.root_.overlaps(other_.root_)) {
      this->visit({one_.root(), other_.root()}, visit);
    }
  }

 private:
  [[nodiscard]] bool within_one() const { return &one_ == &other_; }

  /// Calls add(i) for the marked ones, the last first, as a stack wants them.
  template <class Add>
  static void for_each_marked(unsigned bits, Add&& add) {
    while (bits != 0) {
      const auto i = static_cast<std::uint32_t>(std::bit_width(bits)) - 1;
      add(i);
      bits ^= 1U << i;
    }
  }

  /// Calls add(nodes) for the pairs below that may have items that meet.
  template <class Add>
  void expand(const Nodes& at, Add&& add) const {
    const BoxTree::Node &one = at.one, &other = at.other;
    const auto add_children = [&](bool of_one, unsigned bits) {
      for_each_marked(bits, [&](std::uint32_t i) {
        const Nodes below = of_one ? Nodes{one.child(i), other} : Nodes{one, other.child(i)};
        if (one_.may_meet(below.one, other_, below.other)) {
          add(below);
        }
      });
    };
    if (within_one()) {
      expand_within(at, add);
    } else if (other.is_leaf() ||
               (!one.is_leaf() && larger(one_.box_of(one), other_.box_of(other)))) {
      add_children(true, one_.quad(one).overlapping(other_.box_of(other)));
    } else {
      add_children(false, other_.quad(other).overlapping(one_.box_of(one)));
    }
  }

  /// Within one tree both nodes are at the same level.
  template <class Add>
  void expand_within(const Nodes& at, Add&& add) const {
    const bool same = at.one == at.other;
    const BoxQuad &quad = one_.quad(at.one), &others = one_.quad(at.other);
    for (std::uint32_t i = BoxTree::kFan; i-- > 0;) {
      unsigned meeting = others.overlapping(quad[i]);
      meeting = same ? meeting & ~0U << i : meeting;
      for_each_marked(meeting, [&](std::uint32_t k) {
        const Nodes below{at.one.child(i), at.other.child(k)};
        if (!one_.of_one_group(below.one, below.other) &&
            (below.one == below.other || one_.may_meet(below.one, one_, below.other))) {
          add(below);
        }
      });
    }
  }

  template <class Visit>
  void compare(const Nodes& leaves, Visit& visit) const {
    const bool same = within_one() && leaves.one == leaves.other;
    const BoxQuad &quad = one_.quad(leaves.one), &others = other_.quad(leaves.other);
    for (std::uint32_t i = 0; i < BoxTree::kFan; ++i) {
      unsigned meeting = others.overlapping(quad[i]);
      meeting = same ? meeting & ~1U << i : meeting;
      for (; meeting != 0; meeting &= meeting - 1) {
        const auto k = static_cast<std::uint32_t>(std::countr_zero(meeting));
        const std::uint32_t item = leaves.one.child(i).index, partner = leaves.other.child(k).index;
        if (!(within_one() && one_.items_of_one_group(item, partner))) {
          visit(item, partner);
        }
      }
    }
  }

  [[nodiscard]] static bool larger(const Box& a, const Box& b) {
    const auto extent = [](const Box& box) {
      return box.high[0] - box.low[0] + (box.high[1] - box.low[1]) + (box.high[2] - box.low[2]);
    };
    return extent(a) > extent(b);
  }

  const BoxTree &one_, &other_;
};

}  // namespace dupin::boxes
