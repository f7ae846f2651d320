#include "arrangement/points/coincident_point_index.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "arrangement/points/implicit_predicates.h"
#include "support/blocks.h"
#include "support/bulk_vector.h"
#include "support/hash.h"

namespace dupin::arrangement {
namespace {

// Cells of 2^-40 of the extent: intervals of a few ulp (2^-52) rarely reach into a second one.
constexpr int kCellBits = 40;
// No cell lies beyond, except those of intervals without bounds.
constexpr double kLimit = 0x1p60;

template <class Cells, class Visit>
void for_each_cell(const Cells& cells, Visit&& visit) {
  for (std::int64_t x = cells.low[0]; x <= cells.high[0]; ++x) {
    for (std::int64_t y = cells.low[1]; y <= cells.high[1]; ++y) {
      for (std::int64_t z = cells.low[2]; z <= cells.high[2]; ++z) {
        visit({x, y, z});
      }
    }
  }
}

}  // namespace

CoincidentPointIndex::CoincidentPointIndex(PointTable& points, double extent,
                                           std::size_t expected_count)
    : points_(&points), slots_(std::bit_ceil(2 * expected_count + 16), kNone) {
  int exponent = 0;
  std::frexp(extent, &exponent);
  cells_per_unit_ = std::ldexp(1.0, std::clamp(kCellBits - exponent, -1000, 1000));
  support::reserve_bulk(entries_, expected_count);
}

void CoincidentPointIndex::tighten_wide(PointId begin, PointId end) const {
  constexpr std::size_t kPoints = 256;
  support::for_each_block(
      end - begin,
      [&](const support::Block& block) {
        const UpwardRounding rounding;
        for (std::size_t i = block.begin; i < block.end; ++i) {
          const auto id = static_cast<PointId>(begin + i);
          if (cells_of(id).are_wide()) {
            points_->tighten(id);
          }
        }
      },
      kPoints);
}

PointId CoincidentPointIndex::first_coincident(PointId id) {
  Cells cells = cells_of(id);
  if (cells.are_wide()) {
    points_->tighten(id);
    cells = cells_of(id);
  }
  PointId found = kNone;
  for_each_cell(cells, [&](const Cell& cell) { found = found == kNone ? find(id, cell) : found; });
  if (found != kNone) {
    return found;
  }
  for_each_cell(cells, [&](const Cell& cell) { insert(id, cell); });
  return id;
}

CoincidentPointIndex::Cells CoincidentPointIndex::cells_of(PointId id) const {
  // Rounded down; without instructions for that, this is faster than std::floor.
  const auto index = [](double x) {
    const double limited = std::isnan(x) ? 0 : std::clamp(x, -kLimit, kLimit);
    const auto whole = static_cast<std::int64_t>(limited);
    return static_cast<double>(whole) > limited ? whole - 1 : whole;
  };
  Cells cells;
  for (std::size_t k = 0; k < 3; ++k) {
    const Interval x = points_->interval(id, static_cast<int>(k));
    cells.low[k] = index(x.inf() * cells_per_unit_);
    cells.high[k] = index(x.sup() * cells_per_unit_);
    if (std::isnan(x.inf()) || std::isnan(x.sup())) {
      cells.low[k] = static_cast<std::int64_t>(-kLimit);
      cells.high[k] = static_cast<std::int64_t>(kLimit);
    }
  }
  return cells;
}

std::size_t CoincidentPointIndex::slot_of(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const std::int64_t x : cell) {
    hash = support::mixed(hash, static_cast<std::uint64_t>(x));
  }
  return static_cast<std::size_t>(hash) & (slots_.size() - 1);
}

PointId CoincidentPointIndex::find(PointId id, const Cell& cell) const {
  for (std::uint32_t i = slots_[slot_of(cell)]; i != kNone; i = entries_[i].next) {
    if (entries_[i].cell == cell && coincide(*points_, entries_[i].point, id)) {
      return entries_[i].point;
    }
  }
  return kNone;
}

void CoincidentPointIndex::insert(PointId id, const Cell& cell) {
  std::uint32_t& head = slots_[slot_of(cell)];
  entries_.push_back({cell, id, head});
  head = static_cast<std::uint32_t>(entries_.size() - 1);
}

}  // namespace dupin::arrangement
