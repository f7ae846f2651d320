#include "dupin/kernel/hidden_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "boxes/box_quantizer.h"
#include "boxes/box_tree.h"
#include "boxes/main_directions.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/patch.h"

namespace dupin {

// All in the view's coordinates.
struct HiddenLines::Scene {
  View view;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  boxes::BoxQuantizer quantizer;
  boxes::BoxTree tree;
};

namespace {

boxes::BoxTree tree_of(const boxes::BoxQuantizer& quantizer, const std::vector<Vec3>& points,
                       const std::vector<Triangle>& triangles) {
  std::vector<boxes::Box> all;
  all.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    all.push_back(quantizer.around(quantizer.map(points[a], points[b], points[c])));
  }
  return boxes::BoxTree(std::span<const boxes::Box>(all));
}

std::vector<Vec3> seen_by(const View& view, const std::vector<Vec3>& points) {
  std::vector<Vec3> result(points.size());
  std::ranges::transform(points, result.begin(), view);
  return result;
}

// The picture turned so that boxes around the triangles, and around lines like theirs, are small.
View turned(const View& view, const TriMesh& mesh) {
  std::vector<Vec3> flat = seen_by(view, mesh.points);
  std::ranges::for_each(flat, [](Vec3& point) { point[2] = 0; });
  const auto axes = boxes::main_directions(flat, mesh.triangles);
  if (!axes) {
    return view;
  }
  const double c = (*axes)(0, 0), s = (*axes)(0, 1);
  return {c * view.right + s * view.up, c * view.up - s * view.right, view.towards};
}

double turn(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Keeps of [from, to] where a linear function is positive that is `at_start` at 0, `at_end` at 1.
void clip(double at_start, double at_end, Stretch& kept) {
  if (at_start <= 0 && at_end <= 0) {
    kept.to = kept.from;
  } else if (at_start < 0) {
    kept.from = std::max(kept.from, at_start / (at_start - at_end));
  } else if (at_end < 0) {
    kept.to = std::min(kept.to, at_start / (at_start - at_end));
  }
}

// On which side of an edge a point is; for the edge's other triangle it is exactly the opposite.
double side_of(const Vec3& a, const Vec3& b, const Vec3& point) {
  const bool is_forward = std::pair(a[0], a[1]) < std::pair(b[0], b[1]);
  return is_forward ? turn(a, b, point) : -turn(b, a, point);
}

// Of a line that is along an edge in the picture, a triangle covers one side only.
using Sides = std::array<bool, 2>;

// The fractions of p to q that are behind the triangle, and whether its front is seen.
struct Covered {
  Stretch stretch;
  bool by_front;
  Sides sides;
};

std::optional<Covered> covered(const Vec3& p, const Vec3& q, Vec3 a, Vec3 b, const Vec3& c) {
  const double size = turn(a, b, c);
  if (size == 0) {
    return std::nullopt;  // seen from the side
  }
  if (size < 0) {
    std::swap(a, b);
  }
  Stretch kept{0, 1};
  Sides sides{true, true};
  const auto clip_by = [&](const Vec3& from, const Vec3& to) {
    const double at_p = side_of(from, to, p), at_q = side_of(from, to, q);
    if (at_p != 0 || at_q != 0) {
      return clip(at_p, at_q, kept);
    }
    const Vec3 along = to - from;
    sides[along[1] < 0 || (along[1] == 0 && along[0] > 0) ? 1 : 0] = false;
  };
  clip_by(a, b);
  clip_by(b, c);
  clip_by(c, a);
  const Vec3 normal = (b - a).cross(c - a);  // towards the viewer
  clip(normal.dot(a - p), normal.dot(a - q), kept);
  return kept.from < kept.to ? std::optional(Covered{kept, size > 0, sides}) : std::nullopt;
}

// Where the fronts and backs before either side of the line change in number.
struct Step {
  double at;
  std::array<int, 2> triangles, winding;
};

// Stretches along a polyline, by their lengths.
class Joiner {
 public:
  Joiner(std::span<const Vec3> polyline, double least) : least_(least) {
    lengths_.reserve(polyline.size());
    lengths_.push_back(0);
    for (std::size_t i = 1; i < polyline.size(); ++i) {
      lengths_.push_back(lengths_.back() + (polyline[i] - polyline[i - 1]).norm());
    }
  }

  // Where the sums of the steps are not zero on either side. What rounding makes goes first: else
  // much of it, near each other, would become a stretch.
  [[nodiscard]] std::vector<Stretch> where(std::span<const Step> steps,
                                           std::array<int, 2> Step::*count) const {
    constexpr double kRounding = 1e-9;  // of the whole length
    std::vector<Stretch> all;
    std::array<int, 2> sum{};
    bool was = false;
    for (const Step& step : steps) {
      sum[0] += (step.*count)[0];
      sum[1] += (step.*count)[1];
      const bool is = sum[0] != 0 && sum[1] != 0;
      if (!was && is) {
        all.push_back({step.at, step.at});
      } else if (was && !is) {
        all.back().to = step.at;
      }
      was = is;
    }
    return cleaned(cleaned(all, kRounding * lengths_.back()), least_);
  }

 private:
  // Without gaps, and then without stretches, shorter than `least`.
  [[nodiscard]] std::vector<Stretch> cleaned(const std::vector<Stretch>& all, double least) const {
    std::vector<Stretch> result;
    for (const Stretch& one : all) {
      const double before = result.empty() ? 0 : result.back().to;
      const bool is_near = length(before, one.from) <= least;
      if (result.empty() || !is_near) {
        result.push_back({is_near ? before : one.from, one.to});
      } else {
        result.back().to = one.to;
      }
    }
    const auto last = static_cast<double>(lengths_.size() - 1);
    if (!result.empty() && length(result.back().to, last) <= least) {
      result.back().to = last;
    }
    std::erase_if(result, [&](const Stretch& one) { return length(one.from, one.to) < least; });
    return result;
  }
  [[nodiscard]] double length(double from, double to) const { return at(to) - at(from); }
  [[nodiscard]] double at(double parameter) const {
    const std::size_t i = std::min(std::size_t(parameter), lengths_.size() - 2);
    return lengths_[i] + (parameter - double(i)) * (lengths_[i + 1] - lengths_[i]);
  }

  double least_;
  std::vector<double> lengths_;
};

}  // namespace

HiddenLines::HiddenLines(const TriMesh& mesh, const View& view) {
  validate(mesh);
  if (!view.right.allFinite() || !view.up.allFinite() || !view.towards.allFinite()) {
    throw Error(Errc::invalid_argument, "the directions of a view must be finite");
  }
  const View picture = turned(view, mesh);
  std::vector<Vec3> points = seen_by(picture, mesh.points);
  const boxes::BoxQuantizer quantizer{std::span<const Vec3>(points)};
  boxes::BoxTree tree = tree_of(quantizer, points, mesh.triangles);
  scene_ = std::make_unique<const Scene>(
      Scene{picture, std::move(points), mesh.triangles, quantizer, std::move(tree)});
}

HiddenLines::~HiddenLines() = default;

SeenLine HiddenLines::seen(std::span<const Vec3> polyline, double least) const {
  if (!std::isfinite(least) ||
      !std::ranges::all_of(polyline, [](const Vec3& point) { return point.allFinite(); })) {
    throw Error(Errc::invalid_argument,
                "the points of a line, and the least length of a stretch, must be finite");
  }
  if (polyline.size() < 2) {
    return {};
  }
  std::vector<Step> steps;
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    const Vec3 p = scene_->view(polyline[i]), q = scene_->view(polyline[i + 1]);
    boxes::Box box = scene_->quantizer.around(scene_->quantizer.map(p, q, q));
    box.high[2] = std::numeric_limits<float>::infinity();
    scene_->tree.visit(box, [&](std::uint32_t item) {
      const auto& [a, b, c] = scene_->triangles[item];
      const auto& points = scene_->points;
      if (const auto found = covered(p, q, points[a], points[b], points[c])) {
        const int left = found->sides[0] ? 1 : 0, right = found->sides[1] ? 1 : 0;
        const int turns = found->by_front ? 1 : -1;
        steps.push_back(
            {double(i) + found->stretch.from, {left, right}, {left * turns, right * turns}});
        steps.push_back(
            {double(i) + found->stretch.to, {-left, -right}, {-left * turns, -right * turns}});
      }
    });
  }
  std::ranges::stable_sort(steps, {}, &Step::at);
  const Joiner joiner(polyline, least);
  return {joiner.where(steps, &Step::triangles), joiner.where(steps, &Step::winding)};
}

}  // namespace dupin
