#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "arrangement/points/implicit_points.h"

namespace dupin::arrangement {

/// Finds points of a table that have the same coordinates, exactly: a hash of grid cells far
/// smaller than most distances and larger than the points' intervals. Where many points are in one
/// cell, as where operands are turned by next to nothing against each other, all but the first few
/// have names, found from their exact coordinates: points that coincide have the same (residue.h).
class CoincidentPointIndex {
 public:
  /// `extent` bounds the magnitude of all coordinates. There may be more points than expected.
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
    std::uint64_t name;  ///< 0 for none
    PointId point;
    std::uint32_t next;
  };
  struct Cells {
    Cell low, high;
    [[nodiscard]] bool are_wide() const {
      return high[0] - low[0] > 1 || high[1] - low[1] > 1 || high[2] - low[2] > 1;
    }
  };

  struct Sought {
    PointId id;
    std::optional<std::uint64_t> name;  ///< once it is asked for; 0 if it can have none
  };

  [[nodiscard]] Cells cells_of(PointId id) const;
  [[nodiscard]] std::size_t slot_of(const Cell& cell, std::uint64_t name) const;
  /// The entries with that cell and name, the latest first, until visit(entry) is true.
  template <class Visit>
  void visit_entries(const Cell& cell, std::uint64_t name, Visit&& visit) const;
  [[nodiscard]] PointId find(Sought& point, const Cell& cell) const;
  [[nodiscard]] bool is_crowded(const Cell& cell) const;
  [[nodiscard]] std::uint64_t name_of(Sought& point) const;
  void insert(Sought& point, const Cell& cell);
  void put_in_slot(std::uint32_t index);

  PointTable* points_;
  double cells_per_unit_;  // a power of two
  std::vector<std::uint32_t> slots_;
  std::vector<Entry> entries_;
};

}  // namespace dupin::arrangement
