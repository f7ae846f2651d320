#pragma once

#include <array>
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
    std::uint32_t one, other;
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
    std::array<Nodes, 256> stack;  // each step of at most 64 down adds three
    std::size_t depth = 0;
    stack[depth++] = nodes;
    while (depth > 0) {
      const Nodes at = stack[--depth];
      if (is_leaf(one_, at.one) && is_leaf(other_, at.other)) {
        compare(at, visit);
      } else {
        expand(at, [&](const Nodes& below) { stack[depth++] = below; });
      }
    }
  }

 private:
  [[nodiscard]] static bool is_leaf(const BoxTree& tree, std::uint32_t node) {
    return node >= tree.leaves_;
  }
  [[nodiscard]] bool within_one() const { return &one_ == &other_; }
  [[nodiscard]] bool overlap(const Nodes& nodes) const;

  /// Calls add(nodes) for the pairs below that may have items that meet.
  template <class Add>
  void expand(const Nodes& at, Add&& add) const {
    const auto add_overlapping = [&](const Nodes& below) {
      if (overlap(below)) {
        add(below);
      }
    };
    const std::uint32_t one = 2 * at.one, other = 2 * at.other;
    if (within_one() && at.one == at.other) {
      add_overlapping({one, one});
      add_overlapping({one + 1, one + 1});
      add_overlapping({one, one + 1});
    } else if (within_one()) {  // at the same depth
      for (const std::uint32_t i : {one, one + 1}) {
        add_overlapping({i, other});
        add_overlapping({i, other + 1});
      }
    } else if (is_leaf(other_, at.other) ||
               (!is_leaf(one_, at.one) && larger(one_.nodes_[at.one], other_.nodes_[at.other]))) {
      add_overlapping({one, at.other});
      add_overlapping({one + 1, at.other});
    } else {
      add_overlapping({at.one, other});
      add_overlapping({at.one, other + 1});
    }
  }

  template <class Visit>
  void compare(const Nodes& leaves, Visit& visit) const {
    const bool same = within_one() && leaves.one == leaves.other;
    const std::uint32_t one = leaves.one - one_.leaves_, other = leaves.other - other_.leaves_;
    const std::uint32_t end = one_.leaf_end(one), other_end = other_.leaf_end(other);
    for (std::uint32_t i = one * BoxTree::kLeafSize; i < end; ++i) {
      if (!one_.boxes_[i].overlaps(other_.nodes_[leaves.other])) {
        continue;
      }
      for (std::uint32_t k = same ? i + 1 : other * BoxTree::kLeafSize; k < other_end; ++k) {
        if (one_.boxes_[i].overlaps(other_.boxes_[k]) &&
            !(within_one() && one_.items_of_one_group(i, k))) {
          visit(i, k);
        }
      }
    }
  }

  [[nodiscard]] static bool larger(const Box& a, const Box& b);

  const BoxTree &one_, &other_;
};

}  // namespace dupin::boxes
