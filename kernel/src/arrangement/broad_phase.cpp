#include "arrangement/broad_phase.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <span>

#include "boxes/box_tree.h"
#include "boxes/main_directions.h"
#include "boxes/tree_traversal.h"
#include "support/blocks.h"
#include "support/operation_limits.h"
#include "support/sort_by_key.h"

namespace dupin::arrangement {
namespace {

using Bounds = Eigen::AlignedBox3d;
using Axes = Eigen::Matrix3d;  // unit rows, orthogonal to within rounding

// axes * point, the quick way.
Vec3 rotated(const Axes& axes, const Vec3& point) {
  return {axes.row(0).dot(point), axes.row(1).dot(point), axes.row(2).dot(point)};
}

// An operand in a frame that fits it, with the boxes of runs of its triangles. Rotated coordinates
// only cull; all boxes are inflated by more than rounding can amount to.
struct FramedOperand {
  static constexpr std::uint32_t kRun = 32;

  Axes axes = Axes::Identity();  // the longest extent first
  Bounds bounds;                 // in these axes
  std::vector<Bounds> runs;      // of triangles kRun i and on, in these axes
};

Bounds run_bounds(const mesh::ExactMesh& mesh, std::size_t begin, std::size_t end, const Axes& axes,
                  double slack) {
  Bounds box;
  for (std::size_t t = begin; t < end; ++t) {
    // Neighbours share corners and often follow one another.
    const Triangle& previous = mesh.triangles[t > begin ? t - 1 : t];
    for (const std::uint32_t corner : mesh.triangles[t]) {
      if (t == begin || std::find(previous.begin(), previous.end(), corner) == previous.end()) {
        box.extend(rotated(axes, mesh.points[corner]));
      }
    }
  }
  box.min().array() -= slack;
  box.max().array() += slack;
  return box;
}

// How far rotated coordinates of points, themselves nearest doubles, can be off.
double rotation_slack(double extent) {
  // With u = 2^-52 (rounding upward): a coordinate is a sum of three products, off by less than
  // 3.1 u 3 extent, of a point off by u / 2 in each coordinate. Turning a box back assumes
  // orthogonal axes, which are so within 16 u, for coordinates up to sqrt(3) extent: less than
  // 2^-45 in all.
  return 0x1p-45 * extent;
}

FramedOperand framed(const mesh::ExactMesh& mesh, double slack) {
  FramedOperand result;
  if (mesh.points.empty()) {
    return result;
  }
  result.axes = boxes::principal_axes(mesh.points);
  const std::size_t count = mesh.triangles.size();
  result.runs.resize(support::block_count(count, FramedOperand::kRun));
  support::for_each_block(
      result.runs.size(),
      [&](const support::Block& block) {
        const UpwardRounding rounding;
        for (std::size_t i = block.begin; i < block.end; ++i) {
          const std::size_t begin = i * FramedOperand::kRun;
          const std::size_t end = std::min(begin + FramedOperand::kRun, count);
          result.runs[i] = run_bounds(mesh, begin, end, result.axes, slack);
        }
      },
      support::Block::kSize / FramedOperand::kRun);
  for (const Bounds& run : result.runs) {
    result.bounds.extend(run);
  }
  Eigen::Index longest = 0;
  result.bounds.sizes().maxCoeff(&longest);
  const auto exchange = [longest](Bounds& b) {
    std::swap(b.min()[0], b.min()[longest]);
    std::swap(b.max()[0], b.max()[longest]);
  };
  exchange(result.bounds);
  std::for_each(result.runs.begin(), result.runs.end(), exchange);
  result.axes.row(0).swap(result.axes.row(longest));
  return result;
}

// The bounds in `axes` of a box given in others.
Bounds bounds_in(const Axes& axes, const Axes& others, const Bounds& box, double slack) {
  const Eigen::Matrix3d turn = axes * others.transpose();
  const Vec3 center = turn * box.center();
  const Vec3 reach = turn.cwiseAbs() * (box.sizes() / 2) + Vec3::Constant(2 * slack);
  return Bounds(center - reach, center + reach);
}

// Axes such that the first runs along the first of `a`, and the first of `b` in the plane of the
// first two; those of `a` if both are nearly parallel.
Axes common_axes(const Axes& a, const Axes& b) {
  const Vec3 first = a.row(0), second = b.row(0);
  // Below this angle the second direction says little.
  constexpr double kNearlyParallel = 0.95;
  return std::abs(first.dot(second)) < kNearlyParallel ? boxes::orthonormal(first, second) : a;
}
struct TriangleBox {
  std::array<double, 3> low, high;
  std::uint32_t triangle;
};

bool overlap(const TriangleBox& a, const TriangleBox& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.high[k] < b.low[k] || b.high[k] < a.low[k]) {
      return false;
    }
  }
  return true;
}

bool reaches_into(const TriangleBox& box, const Bounds& window) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    if (box.high[k] < window.min()[axis] || box.low[k] > window.max()[axis]) {
      return false;
    }
  }
  return true;
}

// Long triangles across the axes fill little of their boxes: they are looked at in slices.
class Slicer {
 public:
  Slicer(const Axes& axes, double slack) : axes_(axes), slack_(slack) {}

  void append(const TriangleBox& box, const mesh::ExactMesh& mesh, const Triangle& corners,
              std::vector<TriangleBox>& result) const {
    std::array<double, 3> sizes{};
    for (std::size_t k = 0; k < 3; ++k) {
      sizes[k] = box.high[k] - box.low[k];
    }
    std::sort(sizes.begin(), sizes.end());
    if (sizes[1] * 8 < sizes[2]) {
      result.push_back(box);
      return;
    }
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = rotated(axes_, mesh.points[corners[k]]);
    }
    while ((p[1] - p[0]).squaredNorm() <
           std::max((p[2] - p[1]).squaredNorm(), (p[0] - p[2]).squaredNorm())) {
      std::rotate(p.begin(), p.begin() + 1, p.end());
    }
    const Vec3 along = p[1] - p[0], aside = p[2] - p[0];
    const double length = along.norm(), height = along.cross(aside).norm() / length;
    const double count = std::min(std::floor(length / (2 * height)), kMost);
    if (!(count >= 4)) {
      result.push_back(box);
      return;
    }
    add_slices(p, std::round(aside.dot(along) / (length * length) * count), count, box.triangle,
               result);
  }

 private:
  static constexpr double kMost = 8;

  // Lemma: f affine with f = 0 at p[0], `count` at p[1] and `apex`, a whole number between these,
  // at p[2] has its values in [0, count] on the triangle, which is the union of the parts with f
  // between neighbouring whole numbers. Each is the hull of its corners, which lie on the first
  // edge and on the others; the apex is such a corner.
  void add_slices(const std::array<Vec3, 3>& p, double apex, double count, std::uint32_t triangle,
                  std::vector<TriangleBox>& result) const {
    const auto lower = [&](double f) -> Vec3 { return p[0] + (p[1] - p[0]) * (f / count); };
    const auto upper = [&](double f) -> Vec3 {
      return f < apex   ? p[0] + (p[2] - p[0]) * (f / apex)
             : f > apex ? p[1] + (p[2] - p[1]) * ((count - f) / (count - apex))
                        : p[2];
    };
    for (double f = 0; f < count; ++f) {
      Bounds slice(lower(f));
      slice.extend(upper(f));
      slice.extend(lower(f + 1));
      slice.extend(upper(f + 1));
      // Twice: once for the corners' rounding, and once for that of places between them.
      const Vec3 low = slice.min() - Vec3::Constant(2 * slack_),
                 high = slice.max() + Vec3::Constant(2 * slack_);
      result.push_back({{low[0], low[1], low[2]}, {high[0], high[1], high[2]}, triangle});
    }
  }

  const Axes& axes_;
  double slack_;
};

// Triangles of one operand around a corner, of which there may be thousands.
class Neighbours {
 public:
  Neighbours(const ArrangementInput& input, std::uint32_t operand, const Axes& axes, double slack)
      : input_(input), mesh_(*input.operands[operand]), first_(input.first_triangle[operand]) {
    points_.reserve(mesh_.points.size());
    for (const Vec3& point : mesh_.points) {
      points_.push_back(rotated(axes, point));
    }
    slack_ = Vec3::Constant(slack);
  }

  // False only if one corner is all that they have in common, or other slices of them will do.
  // Lemma: if they meet in more, they do along a ray from there, on which one of them ends first,
  // in the edge opposite to the corner; and some slices of both hold that end.
  [[nodiscard]] bool may_meet(const TriangleBox& a, const TriangleBox& b) const {
    const Triangle &p = input_.triangles[a.triangle], &q = input_.triangles[b.triangle];
    std::size_t common = 0, of_a = 0, of_b = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (p[i] == q[k]) {
          ++common;
          of_a = i;
          of_b = k;
        }
      }
    }
    return common != 1 || reaches_into(b, opposite(a.triangle, of_a)) ||
           reaches_into(a, opposite(b.triangle, of_b));
  }

 private:
  [[nodiscard]] Bounds opposite(std::uint32_t triangle, std::size_t corner) const {
    const Triangle& corners = mesh_.triangles[triangle - first_];
    const Vec3 &from = points_[corners[(corner + 1) % 3]], &to = points_[corners[(corner + 2) % 3]];
    return {from.cwiseMin(to) - slack_, from.cwiseMax(to) + slack_};
  }

  const ArrangementInput& input_;
  const mesh::ExactMesh& mesh_;
  std::uint32_t first_;
  std::vector<Vec3> points_;
  Vec3 slack_;
};

class Finder {
 public:
  explicit Finder(const ArrangementInput& input)
      : input_(input), slack_(rotation_slack(input.extent)), framed_(input.operands.size()) {
    support::for_each_in_parallel(input.operands.size(), [&](std::size_t o) {
      const UpwardRounding rounding;
      framed_[o] = framed(*input.operands[o], slack_);
    });
  }

  // Each operand is culled by what is left of the other, in its own axes; then what is left of both
  // is compared in axes common to them.
  [[nodiscard]] std::vector<TrianglePair> pairs(std::uint32_t a, std::uint32_t b) const {
    if (a == b) {
      return pairs_within(a);
    }
    std::vector<std::uint32_t> a_runs, b_runs;
    Bounds a_bounds = framed_[a].bounds, b_bounds = framed_[b].bounds;
    keep_runs(a, b, b_bounds, a_runs, a_bounds);
    keep_runs(b, a, a_bounds, b_runs, b_bounds);
    keep_runs(a, b, b_bounds, a_runs, a_bounds);
    if (a_runs.empty() || b_runs.empty()) {
      return {};
    }
    const bool a_is_longer = framed_[a].bounds.sizes()[0] >= framed_[b].bounds.sizes()[0];
    const Axes axes = a_is_longer ? common_axes(framed_[a].axes, framed_[b].axes)
                                  : common_axes(framed_[b].axes, framed_[a].axes);
    const auto window = [&](std::uint32_t operand, const Bounds& bounds) {
      return bounds_in(axes, framed_[operand].axes, bounds, slack_);
    };
    std::vector<TriangleBox> b_boxes = boxes(b, b_runs, axes, window(a, a_bounds));
    std::vector<TriangleBox> a_boxes = boxes(a, a_runs, axes, bounds_of(b_boxes));
    b_boxes = within(bounds_of(a_boxes), b_boxes);
    const bool in_slices = expects_many_pairs(a_boxes, b_boxes);
    if (in_slices) {
      a_boxes = within(bounds_of(b_boxes), sliced(a, a_boxes, axes));
      b_boxes = within(bounds_of(a_boxes), sliced(b, b_boxes, axes));
    }
    std::vector<TrianglePair> found = overlapping(a_boxes, b_boxes);
    sort(found, in_slices);
    return found;
  }

 private:
  [[nodiscard]] static bool expects_many_pairs(const std::vector<TriangleBox>& a,
                                               const std::vector<TriangleBox>& b) {
    constexpr double kMany = 32;  // for each box; with fewer, slicing takes longer than it saves
    return expected_pairs(a, b) > kMany * static_cast<double>(a.size() + b.size());
  }

  // If boxes lay anywhere in the bounds of the larger of the two sets.
  [[nodiscard]] static double expected_pairs(const std::vector<TriangleBox>& a,
                                             const std::vector<TriangleBox>& b) {
    const auto sizes = [](const std::vector<TriangleBox>& boxes) {
      Vec3 sum = Vec3::Zero();
      for (const TriangleBox& box : boxes) {
        sum += Vec3(box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]);
      }
      return sum;
    };
    const auto a_count = static_cast<double>(a.size()), b_count = static_cast<double>(b.size());
    if (a.empty() || b.empty()) {
      return 0;
    }
    const Vec3 reach = sizes(a) / a_count + sizes(b) / b_count;
    const Vec3 room = bounds_of(a).sizes().cwiseMax(bounds_of(b).sizes());
    return a_count * b_count * reach.cwiseQuotient(room).cwiseMin(1).prod();
  }

  [[nodiscard]] std::vector<TriangleBox> sliced(std::uint32_t operand,
                                                const std::vector<TriangleBox>& boxes,
                                                const Axes& axes) const {
    const mesh::ExactMesh& mesh = *input_.operands[operand];
    const Slicer slicer(axes, slack_);
    return support::collect_in_order<TriangleBox>(
        boxes.size(), [&](std::size_t i, std::vector<TriangleBox>& slices) {
          const std::uint32_t t = boxes[i].triangle - input_.first_triangle[operand];
          slicer.append(boxes[i], mesh, mesh.triangles[t], slices);
        });
  }

  [[nodiscard]] static std::vector<TrianglePair> overlapping(
      const std::vector<TriangleBox>& a_boxes, const std::vector<TriangleBox>& b_boxes) {
    if (a_boxes.empty() || b_boxes.empty()) {
      return {};
    }
    // Triangles that follow one another are neighbours, mostly: blocks of them make good trees.
    const boxes::BoxQuantizer quantizer = quantizer_for(bounds_of(a_boxes), bounds_of(b_boxes));
    const boxes::BoxTree b_tree = tree_over(b_boxes, quantizer);
    std::vector<std::vector<TrianglePair>> parts(support::block_count(a_boxes.size()));
    support::for_each_block(a_boxes.size(), [&](const support::Block& block) {
      const std::span<const TriangleBox> mine =
          std::span(a_boxes).subspan(block.begin, block.end - block.begin);
      const boxes::BoxTree tree = tree_over(mine, quantizer);
      std::vector<TrianglePair>& found = parts[block.number];
      boxes::TreeTraversal(tree, b_tree).visit([&](std::uint32_t i, std::uint32_t k) {
        const TriangleBox &x = mine[tree.items()[i]], &y = b_boxes[b_tree.items()[k]];
        if (overlap(x, y)) {
          found.push_back({x.triangle, y.triangle});
        }
      });
    });
    return support::joined(std::move(parts));
  }

  // Pairs of several slices are several times there.
  void sort(std::vector<TrianglePair>& found, bool in_slices) const {
    support::sort_by_key(
        found, static_cast<std::uint32_t>(input_.triangles.size()),
        [](const TrianglePair& pair) { return pair.first; }, std::less<>());
    if (in_slices) {
      found.erase(std::unique(found.begin(), found.end()), found.end());
    }
  }

  [[nodiscard]] std::vector<TrianglePair> pairs_within(std::uint32_t operand) const {
    std::vector<std::uint32_t> runs(framed_[operand].runs.size());
    std::iota(runs.begin(), runs.end(), 0u);
    const Axes& axes = framed_[operand].axes;
    std::vector<TriangleBox> all = boxes(operand, runs, axes, framed_[operand].bounds);
    const bool in_slices = expects_many_pairs(all, all);
    if (in_slices) {
      all = sliced(operand, all, axes);
    }
    const boxes::BoxTree tree = tree_over(all, quantizer_for(bounds_of(all), Bounds()));
    const Neighbours neighbours(input_, operand, axes, slack_);
    std::vector<TrianglePair> result;
    boxes::TreeTraversal(tree).visit([&](std::uint32_t i, std::uint32_t k) {
      const TriangleBox &x = all[tree.items()[i]], &y = all[tree.items()[k]];
      if (x.triangle != y.triangle && overlap(x, y) && neighbours.may_meet(x, y)) {
        result.push_back({std::min(x.triangle, y.triangle), std::max(x.triangle, y.triangle)});
      }
    });
    sort(result, in_slices);
    return result;
  }

  // The runs of one operand that reach into a box of another's, and their bounds.
  void keep_runs(std::uint32_t operand, std::uint32_t other, const Bounds& box,
                 std::vector<std::uint32_t>& kept, Bounds& bounds) const {
    const FramedOperand& mine = framed_[operand];
    kept.clear();
    bounds.setEmpty();
    if (box.isEmpty()) {
      return;
    }
    const Bounds window = bounds_in(mine.axes, framed_[other].axes, box, slack_);
    for (std::uint32_t i = 0; i < mine.runs.size(); ++i) {
      if (mine.runs[i].intersects(window)) {
        kept.push_back(i);
        bounds.extend(mine.runs[i].intersection(window));
      }
    }
  }

  // Those that reach into a window, in `axes`.
  [[nodiscard]] std::vector<TriangleBox> boxes(std::uint32_t operand,
                                               const std::vector<std::uint32_t>& runs,
                                               const Axes& axes, const Bounds& window) const {
    const mesh::ExactMesh& mesh = *input_.operands[operand];
    return support::collect_in_order<TriangleBox>(
        runs.size() * FramedOperand::kRun, [&](std::size_t n, std::vector<TriangleBox>& found) {
          const std::size_t i = std::size_t{runs[n / FramedOperand::kRun]} * FramedOperand::kRun +
                                n % FramedOperand::kRun;
          const auto t = static_cast<std::uint32_t>(input_.first_triangle[operand] + i);
          if (i >= mesh.triangles.size() || input_.merged[t] || keeps_apart(t)) {
            return;
          }
          const TriangleBox triangle = box(mesh, mesh.triangles[i], axes, t);
          if (reaches_into(triangle, window)) {
            found.push_back(triangle);
          }
        });
  }

  [[nodiscard]] bool keeps_apart(std::uint32_t triangle) const {
    return !input_.crossing.empty() && input_.crossing[triangle] == 0;
  }

  [[nodiscard]] TriangleBox box(const mesh::ExactMesh& mesh, const Triangle& corners,
                                const Axes& axes, std::uint32_t t) const {
    const Vec3 p = rotated(axes, mesh.points[corners[0]]),
               q = rotated(axes, mesh.points[corners[1]]),
               r = rotated(axes, mesh.points[corners[2]]);
    const Vec3 low = p.cwiseMin(q).cwiseMin(r), high = p.cwiseMax(q).cwiseMax(r);
    return {{low[0] - slack_, low[1] - slack_, low[2] - slack_},
            {high[0] + slack_, high[1] + slack_, high[2] + slack_},
            t};
  }

  [[nodiscard]] static boxes::BoxQuantizer quantizer_for(const Bounds& a, const Bounds& b) {
    const Bounds all = a.merged(b);
    return boxes::BoxQuantizer(std::array{all.min(), all.max()});
  }
  // Over boxes in single precision, somewhat larger: threads may round differently.
  [[nodiscard]] static boxes::BoxTree tree_over(std::span<const TriangleBox> triangles,
                                                const boxes::BoxQuantizer& quantizer) {
    constexpr float kMargin = 0x1p-22F;
    support::BulkVector<boxes::Box> mapped(triangles.size());
    support::for_each_block(triangles.size(), [&](const support::Block& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        const auto& [low, high, t] = triangles[i];
        const boxes::FramedPoint from = quantizer.map(Vec3(low[0], low[1], low[2])),
                                 to = quantizer.map(Vec3(high[0], high[1], high[2]));
        mapped[i] = {{from[0] - kMargin, from[1] - kMargin, from[2] - kMargin},
                     {to[0] + kMargin, to[1] + kMargin, to[2] + kMargin}};
      }
    });
    return boxes::BoxTree(std::span<const boxes::Box>(mapped));
  }

  [[nodiscard]] static Bounds bounds_of(std::span<const TriangleBox> boxes) {
    Bounds all;
    for (const TriangleBox& b : boxes) {
      all.extend(Vec3(b.low[0], b.low[1], b.low[2]));
      all.extend(Vec3(b.high[0], b.high[1], b.high[2]));
    }
    return all;
  }
  [[nodiscard]] static std::vector<TriangleBox> within(const Bounds& window,
                                                       std::span<const TriangleBox> boxes) {
    std::vector<TriangleBox> kept;
    std::copy_if(boxes.begin(), boxes.end(), std::back_inserter(kept),
                 [&window](const TriangleBox& b) { return reaches_into(b, window); });
    return kept;
  }

  const ArrangementInput& input_;
  double slack_;
  std::vector<FramedOperand> framed_;
};

}  // namespace

std::vector<TrianglePair> broad_phase(const ArrangementInput& input,
                                      const support::ProgressStage& stage,
                                      std::uint64_t memory_limit) {
  const Finder finder(input);
  const std::uint64_t most = support::most_candidates(memory_limit);
  std::atomic<std::uint64_t> count{0};
  std::vector<std::vector<TrianglePair>> found(input.operand_pairs.size());
  support::for_each_in_parallel(found.size(), [&](std::size_t i) {
    const UpwardRounding rounding;
    std::vector<TrianglePair> own =
        finder.pairs(input.operand_pairs[i][0], input.operand_pairs[i][1]);
    if (count.fetch_add(own.size()) + own.size() <= most) {
      found[i] = std::move(own);
    }
    stage.step(found.size());
  });
  support::refuse_too_many_candidates(input.triangles.size(), count, memory_limit);
  return support::joined(std::move(found));
}

}  // namespace dupin::arrangement
