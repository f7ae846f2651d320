#include "arrangement/winding_numbers.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <optional>
#include <utility>

#include "arrangement/faces/face_outlines.h"
#include "arrangement/operand_slabs.h"
#include "arrangement/points/implicit_predicates.h"
#include "arrangement/triangle_intersection.h"
#include "mesh/ray_crossing.h"
#include "support/blocks.h"
#include "support/sequences.h"

namespace dupin::arrangement {
namespace {

using Counts = std::vector<int>;

Counts sum(Counts a, const Counts& b, int factor = 1) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] += factor * b[i];
  }
  return a;
}

mesh::ExactPoint middle(const PointTable& points, const Triangle& corners) {
  std::array<mesh::ExactPoint, 3> scratch;
  const mesh::ExactPoint& a = points.exact(corners[0], scratch[0]);
  const mesh::ExactPoint& b = points.exact(corners[1], scratch[1]);
  const mesh::ExactPoint& c = points.exact(corners[2], scratch[2]);
  mesh::ExactPoint sum;
  for (std::size_t k = 0; k < 3; ++k) {
    sum[k] = a[k] * (b[3] * c[3]) + b[k] * (a[3] * c[3]) + c[k] * (a[3] * b[3]);
  }
  sum[3] = a[3] * b[3] * c[3] * CGAL::Mpzf(3);
  return sum;
}

// For mesh::ray_crossing().
struct TriangleAndStart {
  const PointTable& points;
  const Triangle &corners, &support;
  PointId start;
  int axis;

  [[nodiscard]] bool is_above(std::size_t i) const {
    return compare(points, corners[i], start, (axis + 2) % 3) > 0;
  }
  [[nodiscard]] int turn(std::size_t i, std::size_t j) const {
    return arrangement::turn(points, corners[i], corners[j], start, axis);
  }
  [[nodiscard]] int side() const {
    return side_of_plane(points, support[0], support[1], support[2], start);
  }
};

using Extent = std::pair<double, double>;

// The ends between which a triangle lies along an axis.
Extent extent(const ArrangementInput& input, const Triangle& corners, int k) {
  const Interval a = input.points.interval(corners[0], k), b = input.points.interval(corners[1], k),
                 c = input.points.interval(corners[2], k);
  return {std::min({a.inf(), b.inf(), c.inf()}), std::max({a.sup(), b.sup(), c.sup()})};
}

class Ray {
 public:
  Ray(const ArrangementInput& input, PointId start, const Projection& front)
      : input_(input), start_(start), axis_(front.axis), direction_(front.orientation) {}

  [[nodiscard]] IntervalPoint start() const { return input_.points.interval(start_); }

  // May be wrong only by saying yes, of a triangle or of what is in a box.
  [[nodiscard]] bool may_meet(const Triangle& corners) const {
    return may_meet([&](int k) { return extent(input_, corners, k); });
  }
  [[nodiscard]] bool may_meet(const ArrangementInput::Bounds& box) const {
    return may_meet([&](int k) { return Extent(box.min()[k], box.max()[k]); });
  }

  // See mesh::ray_crossing().
  [[nodiscard]] int crossing(const Triangle& corners, const Triangle& support) const {
    const TriangleAndStart triangle{input_.points, corners, support, start_, axis_};
    return mesh::ray_crossing(triangle, direction_);
  }

 private:
  template <class ExtentAlong>
  [[nodiscard]] bool may_meet(const ExtentAlong& extent_along) const {
    for (const int k : {(axis_ + 1) % 3, (axis_ + 2) % 3}) {
      const Interval x = input_.points.interval(start_, k);
      const auto [low, high] = extent_along(k);
      if (x.sup() < low || x.inf() > high) {
        return false;
      }
    }
    const Interval x = input_.points.interval(start_, axis_);
    const auto [low, high] = extent_along(axis_);
    return direction_ > 0 ? x.inf() <= high : x.sup() >= low;
  }

  const ArrangementInput& input_;
  PointId start_;
  int axis_, direction_;
};

// How often rays leave an operand more than they enter it: not at all where they start outside of
// its slabs. Triangles in a row are near each other
// in most meshes: from the second ray on, boxes around such runs tell which of them a ray can meet.
class RayCrossings {
 public:
  explicit RayCrossings(const ArrangementInput& input)
      : input_(input),
        runs_(input.operands.size()),
        slabs_(input.operands.size()),
        asked_(input.operands.size(), 0),
        is_solid_(input.operands.size(), 1) {
    for (const auto& [first, second] : input.operand_pairs) {
      is_solid_[first] = first == second ? 0 : is_solid_[first];
    }
  }

  // The triangles that cover the start do not count.
  [[nodiscard]] int of(const Ray& ray, std::size_t operand, std::span<const SignedTriangle> cover) {
    if (const std::optional<int> known = in_front_of_own(operand, cover)) {
      return *known;
    }
    if (asked_[operand] > size(operand) / kSlabsOfAsked && !slabs_[operand]) {
      slabs_[operand].emplace(input_, operand);
    }
    if (slabs_[operand] && !slabs_[operand]->may_contain(ray.start())) {
      return 0;
    }
    if (asked_[operand] != 0 && runs_[operand].empty()) {
      runs_[operand] = boxes_of_runs(operand);
    }
    ++asked_[operand];
    const std::span<const ArrangementInput::Bounds> runs = runs_[operand];
    const std::size_t count = support::block_count(size(operand), kRun);
    std::vector<int> sums(support::block_count(count, kRunsOfBlock), 0);
    support::for_each_block(
        count,
        [&](const support::Block& block) {
          const UpwardRounding rounding;
          for (std::size_t run = block.begin; run < block.end; ++run) {
            if (runs.empty() || ray.may_meet(runs[run])) {
              sums[block.number] += of_run(ray, operand, run, cover);
            }
          }
        },
        kRunsOfBlock);
    return std::accumulate(sums.begin(), sums.end(), 0);
  }

 private:
  // What is in front of a face of a solid is outside of it: operands of thousands of parts need not
  // be asked about each of these.
  [[nodiscard]] std::optional<int> in_front_of_own(std::size_t operand,
                                                   std::span<const SignedTriangle> cover) const {
    std::optional<int> count;
    for (const SignedTriangle& t : cover) {
      if (input_.operand_of(t.triangle) == operand) {
        if (count || is_solid_[operand] == 0) {
          return std::nullopt;
        }
        count = t.sign < 0 ? 1 : 0;
      }
    }
    return count;
  }

  // Slabs are made by one thread, and are worth it from the second time on for so many triangles.
  static constexpr std::size_t kSlabsOfAsked = 4096;
  static constexpr std::size_t kRun = 64, kRunsOfBlock = support::Block::kSize / kRun;

  [[nodiscard]] std::size_t size(std::size_t operand) const {
    return input_.first_triangle[operand + 1] - input_.first_triangle[operand];
  }

  // Calls visit(triangle) for those of a run.
  template <class Visit>
  void for_each_of(std::size_t operand, std::size_t run, const Visit& visit) const {
    const std::size_t first = input_.first_triangle[operand];
    const std::size_t end = std::min((run + 1) * kRun, size(operand));
    for (std::size_t i = run * kRun; i < end; ++i) {
      visit(static_cast<std::uint32_t>(first + i));
    }
  }

  [[nodiscard]] int of_run(const Ray& ray, std::size_t operand, std::size_t run,
                           std::span<const SignedTriangle> cover) const {
    int sum = 0;
    for_each_of(operand, run, [&](std::uint32_t t) {
      const auto is_t = [t](const SignedTriangle& s) { return s.triangle == t; };
      if (ray.may_meet(input_.triangles[t]) && std::none_of(cover.begin(), cover.end(), is_t)) {
        sum += ray.crossing(input_.triangles[t], input_.support(t));
      }
    });
    return sum;
  }

  [[nodiscard]] std::vector<ArrangementInput::Bounds> boxes_of_runs(std::size_t operand) const {
    std::vector<ArrangementInput::Bounds> boxes(support::block_count(size(operand), kRun));
    support::for_each_block(
        boxes.size(),
        [&](const support::Block& block) {
          const UpwardRounding rounding;
          for (std::size_t run = block.begin; run < block.end; ++run) {
            for_each_of(operand, run, [&](std::uint32_t t) {
              for (int k = 0; k < 3; ++k) {
                const auto [low, high] = extent(input_, input_.triangles[t], k);
                boxes[run].min()[k] = std::min(boxes[run].min()[k], low);
                boxes[run].max()[k] = std::max(boxes[run].max()[k], high);
              }
            });
          }
        },
        kRunsOfBlock);
    return boxes;
  }

  const ArrangementInput& input_;
  std::vector<std::vector<ArrangementInput::Bounds>> runs_;  // per operand
  std::vector<std::optional<OperandSlabs>> slabs_;           // of those asked about often enough
  std::vector<std::uint32_t> asked_;
  std::vector<std::uint8_t> is_solid_;  // those not compared with themselves
};

// A point for which it may not be told whether the box contains it.
bool may_contain(const ArrangementInput::Bounds& box, const IntervalPoint& point) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    if (point[k].sup() < box.min()[axis] || point[k].inf() > box.max()[axis]) {
      return false;
    }
  }
  return true;
}

// How often the operands of each group contain what lies right in front of a part of a face: signed
// crossings of a ray from its middle. Lemma: a closed surface winds 0 times around what lies
// outside its box, so whatever a ray leaves of such an operand it has entered before. `corners`
// span the part, `support` gives its plane and orientation, and `cover` the triangles it is part
// of. Adds a point to the input and removes it. O(triangles) in the worst case. Needs
// UpwardRounding.
Counts winding_numbers_at(ArrangementInput& input, RayCrossings& crossings, const BooleanRule& rule,
                          const Triangle& corners, const Triangle& support,
                          std::span<const SignedTriangle> cover) {
  const PointId start = input.points.add(middle(input.points, corners));
  const Ray ray(input, start, projection_of(input.points, support));
  const IntervalPoint place = input.points.interval(start);
  std::vector<int> counts(rule.groups, 0);
  for (std::size_t o = 0; o < input.operands.size(); ++o) {
    if (may_contain(input.bounds[o], place)) {
      counts[rule.group_of_operand[o]] += crossings.of(ray, o, cover);
    }
  }
  input.points.remove_last();
  return counts;
}

// Patches connected by seams, and the counts in front of each relative to its root.
class Relations {
 public:
  Relations(std::uint32_t size, std::uint32_t groups)
      : parent_(size), offset_(size, Counts(groups, 0)) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) {
      const std::uint32_t up = parent_[i];
      offset_[i] = up == parent_[up] ? offset_[i] : sum(offset_[i], offset_[up]);
      i = parent_[i] = parent_[up];
    }
    return i;
  }
  [[nodiscard]] Counts offset(std::uint32_t i) const {
    Counts total = offset_[i];
    for (i = parent_[i]; parent_[i] != i; i = parent_[i]) {
      total = sum(std::move(total), offset_[i]);
    }
    return total;
  }
  // The counts in front of b are those in front of a plus `step`.
  void relate(std::uint32_t a, std::uint32_t b, const Counts& step) {
    const std::uint32_t ra = root(a), rb = root(b);
    if (ra == rb) {
      assert(offset(b) == sum(offset(a), step));
      return;
    }
    const Counts from_ra_to_rb = sum(sum(offset(a), step), offset(b), -1);
    if (ra < rb) {
      parent_[rb] = ra;
      offset_[rb] = from_ra_to_rb;
    } else {
      parent_[ra] = rb;
      offset_[ra] = sum(Counts(from_ra_to_rb.size(), 0), from_ra_to_rb, -1);
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<Counts> offset_;  // zero for roots
};

// Between two neighbouring half-planes the counts are the same: those on the side of the first that
// faces onward are those on the side of the second that faces back. Forward ones have their front
// onward.
void relate_around(const ArrangementInput& input, const ManifoldPatches& patches,
                   const support::IndexRange& seam, Relations& relations) {
  const auto patch = [&](const HalfPlane& s) { return patches.of_member(s.owner); };
  const std::span<const ManifoldPatches::Side> sides = patches.sides(seam);
  const std::uint32_t first_root = relations.root(patch(sides[0].half_plane));
  if (std::all_of(sides.begin(), sides.end(), [&](const ManifoldPatches::Side& side) {
        return relations.root(patch(side.half_plane)) == first_root;
      })) {
    return;
  }
  std::vector<HalfPlane> half_planes;
  for (const ManifoldPatches::Side& side : sides) {
    half_planes.push_back(side.half_plane);
  }
  order_facets_around_edge(input, half_planes);
  for (std::size_t i = 0; i < half_planes.size(); ++i) {
    const HalfPlane &a = half_planes[i], &b = half_planes[(i + 1) % half_planes.size()];
    Counts step(patches.change(patch(a)).size(), 0);
    if (!a.forward) {
      step = sum(std::move(step), patches.change(patch(a)));
    }
    if (b.forward) {
      step = sum(std::move(step), patches.change(patch(b)), -1);
    }
    relations.relate(patch(a), patch(b), step);
  }
}

// The seams that may relate patches which earlier ones do not: most follow each other along a
// curve, with the same patches around them.
std::vector<std::uint32_t> relating_seams(const ManifoldPatches& patches) {
  const std::vector<support::IndexRange>& seams = patches.seams();
  std::vector<std::vector<std::uint32_t>> relating(support::block_count(seams.size()));
  support::for_each_block(seams.size(), [&](const support::Block& block) {
    std::vector<std::uint32_t> here, before;
    for (std::size_t i = block.begin; i < block.end; ++i) {
      here.clear();
      for (const ManifoldPatches::Side& side : patches.sides(seams[i])) {
        here.push_back(patches.of_member(side.half_plane.owner));
      }
      support::sort_unique(here);
      if (here.size() > 1 && here != before) {
        relating[block.number].push_back(static_cast<std::uint32_t>(i));
        std::swap(here, before);
      }
    }
  });
  return support::joined(std::move(relating));
}

// Some triangle of each set of related patches: an untouched triangle where possible.
struct Sample {
  enum class Kind : std::uint8_t { none, untouched, sub_triangle, outline };
  Kind kind = Kind::none;
  std::uint32_t index = 0;  // of the triangle, sub-triangle or outline
};

// By the root of the set.
std::vector<Sample> find_samples(const ArrangementInput& input, const Subdivision& subdivision,
                                 const ManifoldPatches& patches, Relations& relations) {
  std::vector<Sample> samples(patches.size());
  std::uint32_t missing = 0;
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    missing += relations.root(p) == p ? 1 : 0;
  }
  const auto offer = [&](std::uint32_t patch, Sample::Kind kind, std::uint32_t index) {
    Sample& sample = samples[relations.root(patch)];
    if (sample.kind == Sample::Kind::none) {
      sample = {kind, index};
      --missing;
    }
  };
  for (std::uint32_t t = 0; t < input.triangles.size() && missing > 0; ++t) {
    if (!subdivision.touched[t] && !input.merged[t]) {
      offer(patches.of_triangle(t), Sample::Kind::untouched, t);
    }
  }
  for (std::uint32_t p = 0; p < subdivision.triangles.size() && missing > 0; ++p) {
    offer(patches.of_region(subdivision.triangles[p].region), Sample::Kind::sub_triangle, p);
  }
  for (std::uint32_t i = 0; i < subdivision.outlines.size() && missing > 0; ++i) {
    offer(patches.of_region(subdivision.outlines[i].region), Sample::Kind::outline, i);
  }
  return samples;
}

// A triangle in the sample's place; of an outline, the first one in it.
Subdivision::SubTriangle triangle_of(const ArrangementInput& input, const Subdivision& subdivision,
                                     const Sample& sample) {
  if (sample.kind == Sample::Kind::sub_triangle) {
    return subdivision.triangles[sample.index];
  }
  std::vector<Subdivision::SubTriangle> triangles;
  OutlineTriangulator(input).append(subdivision, subdivision.outlines[sample.index], triangles);
  return triangles.front();
}

Counts counts_in_front_of(ArrangementInput& input, RayCrossings& crossings, const BooleanRule& rule,
                          const Subdivision& subdivision, const Sample& sample) {
  if (sample.kind == Sample::Kind::untouched) {
    return winding_numbers_at(input, crossings, rule, input.triangles[sample.index],
                              input.support(sample.index), input.cover(sample.index));
  }
  const Subdivision::SubTriangle triangle = triangle_of(input, subdivision, sample);
  return winding_numbers_at(input, crossings, rule, triangle.corners,
                            input.support(subdivision.regions[triangle.region].support),
                            subdivision.cover(triangle.region));
}

std::uint32_t patch_of(const Subdivision& subdivision, const ManifoldPatches& patches,
                       const Sample& sample) {
  switch (sample.kind) {
    case Sample::Kind::sub_triangle:
      return patches.of_region(subdivision.triangles[sample.index].region);
    case Sample::Kind::outline:
      return patches.of_region(subdivision.outlines[sample.index].region);
    default:
      return patches.of_triangle(sample.index);
  }
}

}  // namespace

Selection propagate_winding_numbers(ArrangementInput& input, const BooleanRule& rule,
                                    const Subdivision& subdivision,
                                    const ManifoldPatches& patches) {
  Relations relations(patches.size(), rule.groups);
  for (const std::uint32_t seam : relating_seams(patches)) {
    relate_around(input, patches, patches.seams()[seam], relations);
  }
  const std::vector<Sample> samples = find_samples(input, subdivision, patches, relations);
  RayCrossings crossings(input);
  std::vector<Counts> front_of_root(patches.size());
  Selection selection{std::vector<std::int8_t>(patches.size(), 0),
                      std::vector<std::int8_t>(patches.size(), 0)};
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    const std::uint32_t root = relations.root(p);
    if (samples[root].kind == Sample::Kind::none) {
      continue;
    }
    if (front_of_root[root].empty()) {
      const Sample& sample = samples[root];
      const std::uint32_t at = patch_of(subdivision, patches, sample);
      front_of_root[root] = sum(counts_in_front_of(input, crossings, rule, subdivision, sample),
                                relations.offset(at), -1);
    }
    const Counts front = sum(front_of_root[root], relations.offset(p));
    const Counts back = sum(front, patches.change(p));
    const bool is_front_inside = rule.inside(front), is_back_inside = rule.inside(back);
    selection.kept[p] = static_cast<std::int8_t>(int{is_back_inside} - int{is_front_inside});
    selection.outside[p] = !is_front_inside && !is_back_inside ? std::int8_t{1} : std::int8_t{0};
  }
  return selection;
}

}  // namespace dupin::arrangement
