#include "districts/touching_pairs.h"

#include <algorithm>

#include "boxes/box_quantizer.h"
#include "boxes/box_tree.h"
#include "boxes/tree_traversal.h"
#include "districts/boxes_in_tree.h"

namespace dupin::districts {
namespace {

constexpr std::size_t kMostOfBox = 64;  // pairs
constexpr std::size_t kTasks = 1024;    // between them it is seen whether pairs are too many

class Finder {
 public:
  explicit Finder(std::span<const Eigen::AlignedBox3d> boxes) : boxes_(boxes) {}

  [[nodiscard]] bool are_too_many() const { return compared_ > kMostOfBox * boxes_.size(); }

  void compare(std::uint32_t i, std::uint32_t j) {
    ++compared_;
    if (boxes_[i].intersects(boxes_[j]) && !boxes_[i].isEmpty() && !boxes_[j].isEmpty()) {
      found_.push_back({std::min(i, j), std::max(i, j)});
    }
  }

  void compare_all() {
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
      for (std::uint32_t j = i + 1; j < boxes_.size(); ++j) {
        compare(i, j);
      }
    }
  }

  void compare_near() {
    const std::vector<boxes::Box> quick = quick_boxes();
    const boxes::BoxTree tree{std::span<const boxes::Box>(quick)};
    const boxes::TreeTraversal traversal(tree);
    for (const boxes::TreeTraversal::Nodes& nodes : traversal.tasks(kTasks)) {
      traversal.visit(nodes, [&](std::uint32_t i, std::uint32_t j) {
        compare(tree.items()[i], tree.items()[j]);
      });
      if (are_too_many()) {
        return;
      }
    }
  }

  [[nodiscard]] TouchingPairs take() { return std::move(found_); }

 private:
  /// Those of boxes that touch overlap.
  [[nodiscard]] std::vector<boxes::Box> quick_boxes() const {
    const auto finite = [](const Vec3& p) -> Vec3 {
      return p.cwiseMax(-kFarthest).cwiseMin(kFarthest);
    };
    Eigen::AlignedBox3d all;
    for (const Eigen::AlignedBox3d& box : boxes_) {
      all.extend(box);
    }
    const boxes::BoxQuantizer quantizer(std::array{finite(all.min()), finite(all.max())});
    std::vector<boxes::Box> result;
    result.reserve(boxes_.size());
    for (const Eigen::AlignedBox3d& box : boxes_) {
      result.push_back(box.isEmpty() ? boxes::Box::nothing()
                                     : quantizer.around(Eigen::AlignedBox3d(finite(box.min()),
                                                                            finite(box.max()))));
    }
    return result;
  }

  std::span<const Eigen::AlignedBox3d> boxes_;
  std::size_t compared_ = 0;
  TouchingPairs found_;
};

}  // namespace

std::optional<TouchingPairs> touching_pairs(std::span<const Eigen::AlignedBox3d> boxes) {
  Finder finder(boxes);
  if (boxes.size() <= kMostOfBox) {
    finder.compare_all();
  } else {
    finder.compare_near();
  }
  return finder.are_too_many() ? std::nullopt : std::optional(finder.take());
}

}  // namespace dupin::districts
