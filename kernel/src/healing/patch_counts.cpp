#include "healing/patch_counts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <numeric>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "healing/count_descent.h"
#include "healing/count_equations.h"
#include "mesh/edge_table.h"
#include "support/none.h"

namespace dupin::healing {
namespace {

using support::kNone;

// +1 if a half-edge runs from the lower point to the upper one.
int way(const mesh::EdgeTable& edges, std::uint32_t half_edge) {
  return edges.origin(half_edge) < edges.target(half_edge) ? 1 : -1;
}

bool is_balanced(const mesh::EdgeTable& edges, std::size_t edge, std::span<const int> counts) {
  std::int64_t sum = 0;
  for (const std::uint32_t half_edge : edges[edge].half_edges) {
    sum += std::int64_t{way(edges, half_edge)} * counts[half_edge / 3];
  }
  return sum == 0;
}

// Per shell.
std::vector<std::uint8_t> open_shells(const mesh::EdgeTable& edges, const mesh::Shells& shells,
                                      std::span<const int> counts) {
  std::vector<std::uint8_t> is_open(shells.count, 0);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!is_balanced(edges, i, counts)) {
      is_open[shells.of_face[edges[i].half_edges[0] / 3]] = 1;
    }
  }
  return is_open;
}

/// Triangles that hang together by edges of two: they have one count, but for its sign.
struct Patch {
  std::uint32_t first = 0;  ///< triangle
  std::size_t size = 0;
  int least = 0, most = 0;    ///< of the count's size
  std::int64_t majority = 0;  ///< of triangles as they are, relative to the first one
  bool is_one_sided = false;
  bool is_balanced = true;  ///< each triangle as often the one way as the other
};

struct Patches {
  std::vector<std::uint32_t> of_triangle;
  std::vector<int> sign;  ///< of a triangle relative to its patch's first
  std::vector<Patch> patches;
};

// Those of triangles that are `wanted`; all at an edge are, or none.
class PatchFinder {
 public:
  PatchFinder(const mesh::EdgeTable& edges, std::span<const CountRange> ranges)
      : ranges_(ranges), links_(ranges.size(), {kNone, kNone, kNone}), agrees_(ranges.size()) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto along = edges[i].half_edges;
      if (along.size() == 2) {
        const std::uint32_t a = along[0], b = along[1];
        const bool agrees = way(edges, a) != way(edges, b);
        links_[a / 3][a % 3] = b / 3;
        links_[b / 3][b % 3] = a / 3;
        agrees_[a / 3][a % 3] = agrees_[b / 3][b % 3] = agrees ? 1 : -1;
      }
    }
  }

  Patches find(std::span<const std::uint8_t> wanted) {
    found_ = {std::vector(ranges_.size(), kNone), std::vector<int>(ranges_.size(), 1), {}};
    for (std::uint32_t first = 0; first < ranges_.size(); ++first) {
      if (wanted[first] && found_.of_triangle[first] == kNone) {
        grow(first);
      }
    }
    return std::move(found_);
  }

 private:
  void grow(std::uint32_t first) {
    const auto number = static_cast<std::uint32_t>(found_.patches.size());
    Patch patch{.first = first, .most = ranges_[first].most};
    found_.of_triangle[first] = number;
    std::vector<std::uint32_t> queue{first};
    for (std::size_t q = 0; q < queue.size(); ++q) {
      const std::uint32_t t = queue[q];
      include(t, patch);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = links_[t][k];
        if (other == kNone) {
          continue;
        }
        const int sign = found_.sign[t] * agrees_[t][k];
        if (found_.of_triangle[other] == kNone) {
          found_.of_triangle[other] = number;
          found_.sign[other] = sign;
          queue.push_back(other);
        } else {
          patch.is_one_sided |= found_.sign[other] != sign;
        }
      }
    }
    found_.patches.push_back(patch);
  }

  void include(std::uint32_t t, Patch& patch) const {
    const auto [given, least, most] = ranges_[t];
    ++patch.size;
    patch.least = std::max(patch.least, least);
    patch.most = std::min(patch.most, most);
    patch.majority += std::int64_t{found_.sign[t]} * given;
    patch.is_balanced &= given == 0;
  }

  std::span<const CountRange> ranges_;
  std::vector<std::array<std::uint32_t, 3>> links_;
  std::vector<std::array<int, 3>> agrees_;
  Patches found_;
};

// What the patches at each edge add up to.
std::vector<CountEquation> find_equations(const mesh::EdgeTable& edges, const Patches& patches) {
  std::vector<CountEquation> equations;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto along = edges[i].half_edges;
    if (along.size() == 2 || patches.of_triangle[along[0] / 3] == kNone) {
      continue;
    }
    std::vector<CountEquation::Term> terms;
    for (const std::uint32_t half_edge : along) {
      terms.push_back({patches.of_triangle[half_edge / 3],
                       way(edges, half_edge) * patches.sign[half_edge / 3]});
    }
    std::ranges::sort(terms, {}, &CountEquation::Term::unknown);
    CountEquation equation;
    for (const CountEquation::Term& term : terms) {
      if (!equation.terms.empty() && equation.terms.back().unknown == term.unknown) {
        equation.terms.back().factor += term.factor;
      } else {
        equation.terms.push_back(term);
      }
    }
    std::erase_if(equation.terms, [](const CountEquation::Term& term) { return term.factor == 0; });
    if (!equation.terms.empty()) {
      equations.push_back(std::move(equation));
    }
  }
  return equations;
}

// What ends nowhere is a body, of which one is to be left, however its copies are turned.
std::vector<UnknownCount> find_unknowns(std::span<const Patch> patches,
                                        std::span<const CountEquation> equations) {
  std::vector<UnknownCount> unknowns;
  unknowns.reserve(patches.size());
  for (const Patch& patch : patches) {
    unknowns.push_back(
        {patch.size, patch.least, patch.is_one_sided ? 0 : patch.most, patch.majority, false});
  }
  for (const CountEquation& equation : equations) {
    for (const CountEquation::Term& term : equation.terms) {
      unknowns[term.unknown].may_vanish = patches[term.unknown].is_balanced;
    }
  }
  return unknowns;
}

void refuse_one_sided(std::span<const Patch> patches, std::span<const Vec3> points,
                      std::span<const Triangle> triangles) {
  for (const Patch& patch : patches) {
    if (patch.is_one_sided && patch.least > 0) {
      throw Error(Errc::not_oriented,
                  "the mesh cannot be repaired: its surface has only one side, near " +
                      decimal(points[triangles[patch.first][0]]));
    }
  }
}

// Copies may cancel, if need be turned; but, unless `freely`, what ends at an edge may only where
// they do as they are.
std::vector<CountRange> ranges_of(std::span<const CopyNumbers> numbers,
                                  const mesh::EdgeTable& edges, bool freely) {
  std::vector<CountRange> ranges;
  ranges.reserve(numbers.size());
  for (const auto& [even, odd] : numbers) {
    ranges.push_back({even - odd, even + odd > 1 ? 0 : 1, even + odd});
  }
  for (std::size_t i = 0; i < edges.size() && !freely; ++i) {
    if (const auto along = edges[i].half_edges; along.size() == 1) {
      const auto [even, odd] = numbers[along[0] / 3];
      ranges[along[0] / 3].least = even > 0 && odd > 0 ? 0 : 1;
    }
  }
  return ranges;
}

/// Counts of what hangs together, some of which is open.
class Closing {
 public:
  Closing(std::span<const Vec3> points, std::span<const Triangle> triangles,
          std::span<const CopyNumbers> numbers)
      : points_(points),
        triangles_(triangles),
        numbers_(numbers),
        edges_(triangles, points.size()),
        shells_(mesh::shells(triangles.size(), edges_)) {
    for (const auto& [even, odd] : numbers) {
      counts_.push_back(even - odd);
    }
    is_open_ = open_shells(edges_, shells_, counts_);
  }

  std::vector<int> find() {
    if (is_any_open()) {
      const std::vector<CountRange> ranges = ranges_of(numbers_, edges_, false);
      for (const std::vector<int>& counts : counts_of_patches(ranges)) {
        take(counts, true);
      }
      if (is_any_open()) {
        take(descended_counts(edges_, ranges), false);
      }
    }
    if (is_any_open()) {
      const std::vector<CountRange> ranges = ranges_of(numbers_, edges_, true);
      for (const std::vector<int>& counts : counts_of_patches(ranges)) {
        take(but_for_nothing(counts), false);
      }
      if (is_any_open()) {
        take(but_for_nothing(descended_counts(edges_, ranges)), false);
      }
    }
    return std::move(counts_);
  }

  [[nodiscard]] const mesh::Shells& shells() const { return shells_; }

 private:
  [[nodiscard]] bool is_any_open() const {
    return std::ranges::find(is_open_, 1) != is_open_.end();
  }

  // First such as trust what is there once, then others; zero of what is closed.
  [[nodiscard]] std::array<std::vector<int>, 2> counts_of_patches(
      std::span<const CountRange> ranges) const {
    std::vector<std::uint8_t> wanted;
    wanted.reserve(triangles_.size());
    for (const std::uint32_t shell : shells_.of_face) {
      wanted.push_back(is_open_[shell]);
    }
    const Patches patches = PatchFinder(edges_, ranges).find(wanted);
    refuse_one_sided(patches.patches, points_, triangles_);
    const std::vector<CountEquation> equations = find_equations(edges_, patches);
    const std::vector<UnknownCount> unknowns = find_unknowns(patches.patches, equations);
    std::array<std::vector<int>, 2> both;
    for (const bool trusting : {true, false}) {
      const std::vector<int> solution = solved_counts(unknowns, equations, trusting);
      std::vector<int>& counts = both[trusting ? 0 : 1];
      counts.assign(triangles_.size(), 0);
      for (std::size_t t = 0; t < triangles_.size(); ++t) {
        if (wanted[t] != 0) {
          counts[t] = patches.sign[t] * solution[patches.of_triangle[t]];
        }
      }
    }
    return both;
  }

  // Where they close what is open; or anywhere, as what agrees most.
  void take(std::span<const int> counts, bool anywhere) {
    const std::vector<std::uint8_t> stays_open = open_shells(edges_, shells_, counts);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const std::uint32_t shell = shells_.of_face[t];
      if (is_open_[shell] != 0 && (anywhere || stays_open[shell] == 0)) {
        counts_[t] = counts[t];
      }
    }
    for (std::size_t shell = 0; shell < shells_.count; ++shell) {
      is_open_[shell] &= stays_open[shell];
    }
  }

  // Of what would be dropped as a whole, its own.
  [[nodiscard]] std::vector<int> but_for_nothing(std::vector<int> counts) const {
    for (std::size_t shell = 0; shell < shells_.count; ++shell) {
      const auto faces = shells_.faces_of(shell);
      if (std::ranges::all_of(faces, [&](std::uint32_t t) { return counts[t] == 0; })) {
        for (const std::uint32_t t : faces) {
          counts[t] = counts_[t];
        }
      }
    }
    return counts;
  }

  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  std::span<const CopyNumbers> numbers_;
  mesh::EdgeTable edges_;
  mesh::Shells shells_;
  std::vector<int> counts_;
  std::vector<std::uint8_t> is_open_;  // per shell
};

// Divides the counts of each shell by what they have in common.
void drop_common_factors(const mesh::Shells& shells, std::vector<int>& counts) {
  for (std::size_t shell = 0; shell < shells.count; ++shell) {
    int common = 0;
    for (const std::uint32_t t : shells.faces_of(shell)) {
      common = std::gcd(common, counts[t]);
    }
    for (const std::uint32_t t : shells.faces_of(shell)) {
      counts[t] = common == 0 ? 0 : counts[t] / common;
    }
  }
}

}  // namespace

std::vector<int> closing_counts(std::span<const Vec3> points, std::span<const Triangle> triangles,
                                std::span<const CopyNumbers> numbers) {
  Closing closing(points, triangles, numbers);
  std::vector<int> counts = closing.find();
  drop_common_factors(closing.shells(), counts);
  return counts;
}

}  // namespace dupin::healing
