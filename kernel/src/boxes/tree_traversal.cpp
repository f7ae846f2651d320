#include "boxes/tree_traversal.h"

namespace dupin::boxes {

std::vector<TreeTraversal::Nodes> TreeTraversal::tasks(std::size_t count) const {
  std::vector<Nodes> tasks = {{one_.root(), other_.root()}}, below;
  if (!within_one() && !one_.root_.overlaps(other_.root_)) {
    return {};
  }
  while (tasks.size() < count) {
    below.clear();
    for (const Nodes& nodes : tasks) {
      if (nodes.one.is_leaf() && nodes.other.is_leaf()) {
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
