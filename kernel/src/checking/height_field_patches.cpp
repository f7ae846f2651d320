#include "checking/height_field_patches.h"

#include <algorithm>
#include <atomic>
#include <numeric>

#include <Eigen/Geometry>

#include "checking/projected_contours.h"
#include "predicates/stable_predicates.h"
#include "support/blocks.h"
#include "support/disjoint_sets.h"
#include "support/none.h"
#include "support/sort_by_key.h"

namespace dupin::checking {
namespace {

/// The ways that triangles may face: along an axis or, three more, against it.
using Way = std::uint8_t;
constexpr Way kNoWay = 6;
constexpr std::uint8_t kNoWayBit = 1U << kNoWay, kMark = 1U << 7;

/// The edge of a triangle between points that have triangles of several patches around them.
struct OuterEdge {
  std::uint32_t low, high, patch, face;
  bool ascends;  // runs from low to high

  friend bool operator<(const OuterEdge& a, const OuterEdge& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.patch < b.patch;
  }
  [[nodiscard]] DirectedEdge directed() const {
    return ascends ? DirectedEdge{low, high} : DirectedEdge{high, low};
  }
};

/// An edge that its patch ends at.
struct BorderEdge {
  std::uint32_t patch, face;
  DirectedEdge edge;
};

/// Calls visit(edges, ascending) for the edges of each patch between the same two points, of which
/// so many ascend.
template <class Visit>
void for_each_bundle(std::span<const OuterEdge> sorted, Visit&& visit) {
  while (!sorted.empty()) {
    std::size_t count = 0, ascending = 0;
    while (count < sorted.size() && !(sorted[0] < sorted[count])) {
      ascending += sorted[count++].ascends ? 1 : 0;
    }
    visit(sorted.first(count), ascending);
    sorted = sorted.subspan(count);
  }
}

HeightFieldPatches none(std::size_t points, std::size_t triangles) {
  return {std::vector<std::uint32_t>(triangles, support::kNone), 0,
          std::vector<std::uint8_t>(points, 0)};
}

class PatchSearch {
 public:
  PatchSearch(std::span<const Vec3> points, std::span<const Triangle> triangles,
              const HeightFieldOptions& options)
      : points_(points),
        triangles_(triangles),
        options_(options),
        ways_(triangles.size()),
        ways_at_(points.size(), 0),
        patch_(triangles.size()),
        patch_end_(static_cast<std::uint32_t>(points.size() + triangles.size())) {}

  HeightFieldPatches run() {
    find_ways();
    if (!is_smooth()) {
      return none(points_.size(), triangles_.size());
    }
    std::vector<std::uint32_t> faces(triangles_.size());
    std::iota(faces.begin(), faces.end(), 0U);
    std::vector<OuterEdge> edges = outer_edges(faces);
    join(edges);
    // Where a patch does not end as it should, what is to blame is left out and the rest halved.
    constexpr int kUnhalved = 2, kRounds = 8;
    for (int round = 1; !edges.empty(); ++round) {
      const std::vector<std::uint32_t> blamed = blamed_faces(borders(edges));
      faces = of_the_same_patches(faces, blamed);
      if (round == kRounds) {
        leave_out(faces);
        break;
      }
      leave_out(blamed);
      if (round >= kUnhalved) {
        halve(faces);
      }
      edges = outer_edges(faces);
    }
    return numbered();
  }

 private:
  /// The axis nearest to the normal, but for a preference that spares facets at 45 degrees to two
  /// axes the choice.
  [[nodiscard]] Way way_of(const Vec3& a, const Vec3& b, const Vec3& c) const {
    constexpr double kPreference = 0.8;
    const Vec3 size = (b - a).cross(c - a).cwiseAbs();
    const double enough = kPreference * size.maxCoeff();
    const int axis = size[0] >= enough ? 0 : size[1] >= enough ? 1 : 2;
    const int turn = predicates::stable_side_of_line(a, b, c, axis, options_.margin);
    return turn == 0 ? kNoWay : static_cast<Way>(turn > 0 ? axis : axis + 3);
  }

  void find_ways() {
    std::ranges::transform(options_.rim, ways_at_.begin(), [](std::uint8_t is_rim) {
      return is_rim != 0 ? kNoWayBit : std::uint8_t{0};  // never inner
    });
    support::for_each_block(triangles_.size(), [&](const support::Block& block) {
      for (std::size_t f = block.begin; f < block.end; ++f) {
        const auto& [a, b, c] = triangles_[f];
        ways_[f] = way_of(points_[a], points_[b], points_[c]);
        patch_[f] = ways_[f] == kNoWay ? support::kNone : ways_[f];
        const auto bit = static_cast<std::uint8_t>(1U << ways_[f]);
        for (const std::uint32_t v : triangles_[f]) {
          const std::atomic_ref seen(ways_at_[v]);
          if ((seen.load(std::memory_order_relaxed) & bit) == 0) {
            seen.fetch_or(bit, std::memory_order_relaxed);
          }
        }
      }
    });
  }

  [[nodiscard]] bool faces_one_way(std::uint32_t point) const {
    const unsigned ways = ways_at_[point] & ~unsigned{kMark};
    return (ways & (ways - 1)) == 0 && ways != kNoWayBit;
  }

  /// True only if all triangles around a point are of one patch, which does not end there.
  [[nodiscard]] bool is_inner(std::uint32_t point) const {
    return options_.closed && faces_one_way(point);
  }

  [[nodiscard]] bool is_smooth() const {
    std::size_t smooth = 0;
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      smooth += faces_one_way(v) ? 1 : 0;
    }
    return static_cast<double>(smooth) >= options_.smooth * static_cast<double>(points_.size());
  }

  [[nodiscard]] std::vector<OuterEdge> outer_edges(const std::vector<std::uint32_t>& faces) const {
    auto edges = support::collect_in_order<OuterEdge>(faces.size(), [&](std::size_t i,
                                                                        std::vector<OuterEdge>&
                                                                            found) {
      const std::uint32_t face = faces[i];
      const Triangle& t = triangles_[face];
      for (int k = 0; patch_[face] != support::kNone && k < 3; ++k) {
        const std::uint32_t from = t[k], to = t[(k + 1) % 3];
        if (!is_inner(from) && !is_inner(to)) {
          found.push_back({std::min(from, to), std::max(from, to), patch_[face], face, from < to});
        }
      }
    });
    support::sort_by_key(
        edges, static_cast<std::uint32_t>(points_.size()),
        [](const OuterEdge& edge) { return edge.low; }, std::less<>());
    return edges;
  }

  /// Makes patches of triangles that face the same way and hang together.
  void join(std::vector<OuterEdge>& edges) {
    support::DisjointSets sets(points_.size() +
                               triangles_.size());  // inner points, triangles without any
    const auto member = [&](std::uint32_t face) {
      const auto inner =
          std::ranges::find_if(triangles_[face], [&](std::uint32_t v) { return is_inner(v); });
      return inner != triangles_[face].end() ? *inner
                                             : static_cast<std::uint32_t>(points_.size()) + face;
    };
    support::for_each_block(triangles_.size(), [&](const support::Block& block) {
      for (auto f = static_cast<std::uint32_t>(block.begin); f < block.end; ++f) {
        const std::uint32_t first = member(f);
        for (const std::uint32_t v : triangles_[f]) {
          if (v != first && is_inner(v)) {
            sets.unite(first, v);
          }
        }
      }
    });
    for_each_bundle(edges, [&](std::span<const OuterEdge> bundle, std::size_t ascending) {
      for (std::size_t i = 1; ascending > 0 && ascending < bundle.size() && i < bundle.size();
           ++i) {
        sets.unite(member(bundle[0].face), member(bundle[i].face));
      }
    });
    support::for_each_block(triangles_.size(), [&](const support::Block& block) {
      for (auto f = static_cast<std::uint32_t>(block.begin); f < block.end; ++f) {
        patch_[f] = patch_[f] == support::kNone ? support::kNone : sets.find(member(f));
      }
    });
    for (OuterEdge& edge : edges) {
      edge.patch = patch_[edge.face];
    }
    const auto ends = [](const OuterEdge& edge) { return std::pair(edge.low, edge.high); };
    for (const support::IndexRange& run : support::ranges_of_equal(edges, ends)) {
      std::stable_sort(edges.begin() + run.begin, edges.begin() + run.end);
    }
  }

  /// The edges that are run through more often one way than the other, by patch.
  [[nodiscard]] static std::vector<BorderEdge> borders(std::span<const OuterEdge> edges) {
    std::vector<BorderEdge> found;
    for_each_bundle(edges, [&](std::span<const OuterEdge> bundle, std::size_t ascending) {
      const std::size_t descending = bundle.size() - ascending;
      for (const OuterEdge& edge : bundle) {
        if (ascending != descending && edge.ascends == (ascending > descending)) {
          found.push_back({edge.patch, edge.face, edge.directed()});
        }
      }
    });
    std::ranges::stable_sort(found, {}, &BorderEdge::patch);
    return found;
  }

  /// Triangles at the borders where patches do not end as they should.
  [[nodiscard]] std::vector<std::uint32_t> blamed_faces(
      const std::vector<BorderEdge>& borders) const {
    const std::vector<support::IndexRange> runs =
        support::ranges_of_equal(borders, [](const BorderEdge& border) { return border.patch; });
    std::vector<std::vector<std::uint32_t>> blamed(runs.size());
    support::for_each_in_parallel(runs.size(), [&](std::size_t r) {
      const auto border = std::span(borders).subspan(runs[r].begin, runs[r].end - runs[r].begin);
      std::vector<DirectedEdge> edges;
      edges.reserve(border.size());
      for (const BorderEdge& edge : border) {
        edges.push_back(edge.edge);
      }
      const Way way = ways_[border[0].face];
      for (const std::uint32_t i :
           region_conflicts(points_, edges, way % 3, way < 3 ? 1 : -1, options_.margin)) {
        blamed[r].push_back(border[i].face);
      }
    });
    return support::joined(std::move(blamed));
  }

  [[nodiscard]] std::vector<std::uint32_t> of_the_same_patches(
      const std::vector<std::uint32_t>& faces, const std::vector<std::uint32_t>& some) const {
    std::vector<std::uint8_t> wanted(some.empty() ? 0 : patch_end_);
    for (const std::uint32_t f : some) {
      wanted[patch_[f]] = 1;
    }
    return some.empty() ? std::vector<std::uint32_t>()
                        : support::collect_in_order<std::uint32_t>(
                              faces.size(), [&](std::size_t i, std::vector<std::uint32_t>& found) {
                                const std::uint32_t patch = patch_[faces[i]];
                                if (patch != support::kNone && wanted[patch] != 0) {
                                  found.push_back(faces[i]);
                                }
                              });
  }

  void leave_out(const std::vector<std::uint32_t>& faces) {
    for (const std::uint32_t f : faces) {
      patch_[f] = support::kNone;
      for (const std::uint32_t v : triangles_[f]) {
        ways_at_[v] |= kNoWayBit;
      }
    }
  }

  /// Makes two patches, of the earlier and the later triangles, of each patch. The faces are all
  /// those of some patches.
  void halve(std::vector<std::uint32_t>& faces) {
    std::erase_if(faces, [&](std::uint32_t f) { return patch_[f] == support::kNone; });
    std::ranges::stable_sort(faces, {}, [&](std::uint32_t f) { return patch_[f]; });
    for (const std::uint32_t f : faces) {
      for (const std::uint32_t v : triangles_[f]) {
        ways_at_[v] &= static_cast<std::uint8_t>(~kMark);
      }
    }
    for (const support::IndexRange& run :
         support::ranges_of_equal(faces, [&](std::uint32_t f) { return patch_[f]; })) {
      const std::uint32_t middle = run.begin + (run.end - run.begin) / 2;
      for (std::uint32_t i = middle; i < run.end; ++i) {
        patch_[faces[i]] = patch_end_;
        for (const std::uint32_t v : triangles_[faces[i]]) {
          ways_at_[v] |= kMark;
        }
      }
      ++patch_end_;
      for (std::uint32_t i = run.begin; i < middle; ++i) {
        for (const std::uint32_t v : triangles_[faces[i]]) {
          ways_at_[v] |= (ways_at_[v] & kMark) != 0 ? kNoWayBit : std::uint8_t{0};
        }
      }
    }
  }

  /// The patches, numbered by their lowest triangles.
  [[nodiscard]] HeightFieldPatches numbered() {
    std::vector<std::uint32_t> number(patch_end_, support::kNone);
    HeightFieldPatches patches;
    for (std::uint32_t& patch : patch_) {
      if (patch != support::kNone) {
        number[patch] = number[patch] == support::kNone ? patches.count++ : number[patch];
        patch = number[patch];
      }
    }
    patches.of_triangle = std::move(patch_);
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      ways_at_[v] = is_inner(v) ? 1 : 0;
    }
    patches.is_inner = std::move(ways_at_);
    return patches;
  }

  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  HeightFieldOptions options_;
  std::vector<Way> ways_;              // of triangles
  std::vector<std::uint8_t> ways_at_;  // of triangles around each point, a bit each
  std::vector<std::uint32_t> patch_;   // of triangles; ways at first
  std::uint32_t patch_end_;            // above all patches
};

}  // namespace

HeightFieldPatches height_field_patches(std::span<const Vec3> points,
                                        std::span<const Triangle> triangles,
                                        const HeightFieldOptions& options) {
  if (points.size() + 2 * triangles.size() >= support::kNone) {  // more than numbers for patches
    return none(points.size(), triangles.size());
  }
  return PatchSearch(points, triangles, options).run();
}

}  // namespace dupin::checking
