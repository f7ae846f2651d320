#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::checking {

/// Two triangles that meet otherwise than neighbours do.
struct FacePair {
  enum class Kind {
    crossing,  ///< they meet in a point or segment that is no common corner or edge
    overlap,   ///< coplanar, with an area in common
    contact,   ///< only in corners or edges of the same coordinates but different indices
  };
  std::uint32_t first = 0, second = 0;  ///< first < second
  Kind kind = Kind::crossing;
  friend auto operator<=>(const FacePair&, const FacePair&) = default;
};

struct SelfIntersectionOptions {
  /// Pairs kept; the lowest ones, whatever their kind. The counts are complete all the same.
  std::size_t limit = std::numeric_limits<std::size_t>::max();
  /// One entry per triangle: only pairs with a non-zero one are examined, and only those for
  /// degeneracy. Empty examines all. Cheap where few are active.
  std::span<const std::uint8_t> active;
  /// Per point the coincident representative, the first one of those that count as the same: they
  /// have the same coordinates, and are contacts where they meet. Others must not coincide, which
  /// is a crossing. Empty finds all points of the same coordinates.
  std::span<const std::uint32_t> representatives;
  /// Whether contacts are sought: where many triangles meet in identical points, that is costly.
  bool contacts = true;
  /// Promises that every edge is run through as often one way as the other; saves work.
  bool closed = false;
  /// Per point 1 where that is not promised of its edges; empty if there are none such.
  std::span<const std::uint8_t> rim;
  /// Per triangle a group, or support::kNone: those of one group certainly keep apart, and have
  /// an area. Empty if there are none.
  std::span<const std::uint32_t> groups;
  /// If above 0, `stable` is sought as well.
  double margin = 0;
  /// Whether a pair is to be counted and kept; all are, if empty. Asked by several threads at once.
  std::function<bool(const FacePair&)> wanted;
  /// The same of two triangles that may meet, either way round: cheaper where it rules out most.
  std::function<bool(std::uint32_t, std::uint32_t)> examined;
  /// The search may end once it has found so many pairs.
  std::size_t enough = std::numeric_limits<std::size_t>::max();
};

struct SelfIntersections {
  std::vector<FacePair> pairs;            ///< ascending
  std::vector<std::uint32_t> degenerate;  ///< collinear or repeated corners; in none of the pairs
  std::size_t crossings = 0, overlaps = 0, contacts = 0;
  bool is_cut_short = false;  ///< there are enough pairs; these are not all, nor always the same
  /// Per triangle 1 if it is one of those that certainly keep an area and, of each other, apart
  /// wherever each coordinate of each point moves by at most the margin. Not all such triangles are
  /// found; empty if none are.
  std::vector<std::uint8_t> stable;

  [[nodiscard]] std::size_t count() const { return crossings + overlaps + contacts; }
  [[nodiscard]] bool none() const { return degenerate.empty() && crossings == 0 && overlaps == 0; }
};

/// All pairs of triangles that meet where they should not, by exact predicates on the coordinates
/// given. Neighbours share indices; merge identical points first where contacts should count as
/// neighbourhood. Points are finite, indices in range. Deterministic; parallel; O(n log n) if boxes
/// overlap O(1) others.
[[nodiscard]] SelfIntersections find_self_intersections(
    std::span<const Vec3> points, std::span<const Triangle> triangles,
    const SelfIntersectionOptions& options = {});

}  // namespace dupin::checking
