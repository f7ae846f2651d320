#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "arrangement/points/implicit_points.h"

namespace dupin::arrangement {

/// Finds points of a table that have the same coordinates, exactly: a hash of grid cells far
/// smaller than most distances and larger than the points' intervals.
class CoincidentPointIndex {
 public:
  /// `extent` bounds the magnitude of all coordinates.
  CoincidentPointIndex(PointTable& points, double extent, std::size_t expected_count);

  /// Tightens those of the points `begin` to before `end` that first_coincident() would tighten one
  /// by one, in parallel.
  void tighten_wide(PointId begin, PointId end) const;

  /// The first point inserted that has the coordinates of `id`; `id` itself if there is none, and
  /// then it is inserted. Needs UpwardRounding.
  PointId first_coincident(PointId id);

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Entry {
    Cell cell;
    PointId point;
    std::uint32_t next;
  };
  struct Cells {
    Cell low, high;
    [[nodiscard]] bool are_wide() const {
      return high[0] - low[0] > 1 || high[1] - low[1] > 1 || high[2] - low[2] > 1;
    }
  };

  [[nodiscard]] Cells cells_of(PointId id) const;
  [[nodiscard]] std::size_t slot_of(const Cell& cell) const;
  [[nodiscard]] PointId find(PointId id, const Cell& cell) const;
  void insert(PointId id, const Cell& cell);

  PointTable* points_;
  double cells_per_unit_;  // a power of two
  std::vector<std::uint32_t> slots_;
  std::vector<Entry> entries_;
};

}  // namespace dupin::arrangement
