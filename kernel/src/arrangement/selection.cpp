#include "selection.h"

#include <algorithm>
#include <cassert>

#include "ray.h"

namespace dupin::detail {
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
void relate_around(const Scene& scene, const Patches& patches, const Run& seam,
                   Relations& relations) {
  const auto patch = [&](const Sheet& s) { return patches.of_member(s.owner); };
  const std::span<const Patches::Side> sides = patches.sides(seam);
  const std::uint32_t first_root = relations.root(patch(sides[0].sheet));
  if (std::all_of(sides.begin(), sides.end(), [&](const Patches::Side& side) {
        return relations.root(patch(side.sheet)) == first_root;
      })) {
    return;
  }
  std::vector<Sheet> sheets;
  for (const Patches::Side& side : sides) {
    sheets.push_back(side.sheet);
  }
  sort_around_edge(scene, sheets);
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const Sheet &a = sheets[i], &b = sheets[(i + 1) % sheets.size()];
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
std::vector<Sample> find_samples(const Scene& scene, const Incidences& incidences,
                                 const Pieces& pieces, const Patches& patches,
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
  for (std::uint32_t t = 0; t < scene.triangles.size() && missing > 0; ++t) {
    if (!incidences.touched[t] && !scene.merged[t]) {
      offer(patches.of_triangle(t), true, t);
    }
  }
  for (std::uint32_t p = 0; p < pieces.pieces.size() && missing > 0; ++p) {
    offer(patches.of_region(pieces.pieces[p].region), false, p);
  }
  return samples;
}

Counts counts_in_front_of(Scene& scene, const BooleanRule& rule, const Pieces& pieces,
                          const Sample& sample) {
  if (sample.is_triangle) {
    return counts_in_front(scene, rule, scene.triangles[sample.index], scene.support(sample.index),
                           scene.cover(sample.index));
  }
  const Pieces::Piece& piece = pieces.pieces[sample.index];
  return counts_in_front(scene, rule, piece.corners,
                         scene.support(pieces.regions[piece.region].support),
                         pieces.cover(piece.region));
}

}  // namespace

std::vector<std::int8_t> select(Scene& scene, const BooleanRule& rule, const Incidences& incidences,
                                const Pieces& pieces, const Patches& patches) {
  Relations relations(patches.size(), rule.groups);
  for (const Run& seam : patches.seams()) {
    relate_around(scene, patches, seam, relations);
  }
  const std::vector<Sample> samples = find_samples(scene, incidences, pieces, patches, relations);
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
          sum(counts_in_front_of(scene, rule, pieces, sample), relations.offset(at), -1);
    }
    const Counts front = sum(front_of_root[root], relations.offset(p));
    const Counts back = sum(front, patches.change(p));
    const bool is_front_inside = rule.inside(front), is_back_inside = rule.inside(back);
    selection[p] = static_cast<std::int8_t>(int{is_back_inside} - int{is_front_inside});
  }
  return selection;
}

}  // namespace dupin::detail
