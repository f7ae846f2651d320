#include "boxes/tree_traversal.h"

namespace dupin::boxes {

bool TreeTraversal::overlap(const Nodes& nodes) const {
  const auto [one, other] = nodes;
  return !(within_one() && one_.of_one_group(one, other)) &&
         ((within_one() && one == other) || one_.overlap(one, other_, other));
}

bool TreeTraversal::larger(const Box& a, const Box& b) {
  const auto extent = [](const Box& box) {
    return box.high[0] - box.low[0] + (box.high[1] - box.low[1]) + (box.high[2] - box.low[2]);
  };
  return extent(a) > extent(b);
}

std::vector<TreeTraversal::Nodes> TreeTraversal::tasks(std::size_t count) const {
  std::vector<Nodes> tasks = {{1, 1}}, below;
  if (!within_one() && !overlap({1, 1})) {
    return {};
  }
  while (tasks.size() < count) {
    below.clear();
    for (const Nodes& nodes : tasks) {
      if (is_leaf(one_, nodes.one) && is_leaf(other_, nodes.other)) {
        below.push_back(nodes);
      } else {
        expand(nodes, [&](const Nodes& pair) { below.push_back(pair); });
      }
    }
    const bool only_leaves = below == tasks;
    tasks.swap(below);
    if (only_leaves) {
      break;
    }
  }
  return tasks;
}

}  // namespace dupin::boxes
