#include "arrangement/winding_numbers.h"

#include <algorithm>
#include <cassert>

#include "arrangement/ray_casting.h"

namespace dupin::arrangement {
namespace {

using Counts = std::vector<int>;

Counts sum(Counts a, const Counts& b, int factor = 1) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] += factor * b[i];
  }
  return a;
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

// Between two neighbouring sheets lies one place: the side of the first that faces onward is in
// the same place as the side of the second that faces back. Forward sheets have their front
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

// Some piece of each set of related patches: an untouched triangle where possible.
struct Sample {
  bool found = false;
  bool is_triangle = false;
  std::uint32_t index = 0;  // of the triangle or the piece
};

// By the root of the set.
std::vector<Sample> find_samples(const ArrangementInput& input, const Constraints& constraints,
                                 const Subdivision& pieces, const ManifoldPatches& patches,
                                 Relations& relations) {
  std::vector<Sample> samples(patches.size());
  std::uint32_t missing = 0;
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    missing += relations.root(p) == p ? 1 : 0;
  }
  const auto offer = [&](std::uint32_t patch, bool is_triangle, std::uint32_t index) {
    Sample& sample = samples[relations.root(patch)];
    if (!sample.found) {
      sample = {true, is_triangle, index};
      --missing;
    }
  };
  for (std::uint32_t t = 0; t < input.triangles.size() && missing > 0; ++t) {
    if (!constraints.touched[t] && !input.merged[t]) {
      offer(patches.of_triangle(t), true, t);
    }
  }
  for (std::uint32_t p = 0; p < pieces.pieces.size() && missing > 0; ++p) {
    offer(patches.of_region(pieces.pieces[p].region), false, p);
  }
  return samples;
}

Counts counts_in_front_of(ArrangementInput& input, const BooleanRule& rule,
                          const Subdivision& pieces, const Sample& sample) {
  if (sample.is_triangle) {
    return winding_numbers_at(input, rule, input.triangles[sample.index],
                              input.support(sample.index), input.cover(sample.index));
  }
  const Subdivision::SubTriangle& piece = pieces.pieces[sample.index];
  return winding_numbers_at(input, rule, piece.corners,
                            input.support(pieces.regions[piece.region].support),
                            pieces.cover(piece.region));
}

}  // namespace

std::vector<std::int8_t> propagate_winding_numbers(ArrangementInput& input, const BooleanRule& rule,
                                                   const Constraints& constraints,
                                                   const Subdivision& pieces,
                                                   const ManifoldPatches& patches) {
  Relations relations(patches.size(), rule.groups);
  for (const support::IndexRange& seam : patches.seams()) {
    relate_around(input, patches, seam, relations);
  }
  const std::vector<Sample> samples = find_samples(input, constraints, pieces, patches, relations);
  std::vector<Counts> front_of_root(patches.size());
  std::vector<std::int8_t> selection(patches.size(), 0);
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    const std::uint32_t root = relations.root(p);
    if (!samples[root].found) {
      continue;
    }
    if (front_of_root[root].empty()) {
      const Sample& sample = samples[root];
      const std::uint32_t at = sample.is_triangle
                                   ? patches.of_triangle(sample.index)
                                   : patches.of_region(pieces.pieces[sample.index].region);
      front_of_root[root] =
          sum(counts_in_front_of(input, rule, pieces, sample), relations.offset(at), -1);
    }
    const Counts front = sum(front_of_root[root], relations.offset(p));
    const Counts back = sum(front, patches.change(p));
    const bool is_front_inside = rule.inside(front), is_back_inside = rule.inside(back);
    selection[p] = static_cast<std::int8_t>(int{is_back_inside} - int{is_front_inside});
  }
  return selection;
}

}  // namespace dupin::arrangement
