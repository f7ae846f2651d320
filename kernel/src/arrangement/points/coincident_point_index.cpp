#include "arrangement/points/coincident_point_index.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "arrangement/points/implicit_predicates.h"
#include "exact/residue.h"
#include "support/blocks.h"
#include "support/bulk_vector.h"
#include "support/hash.h"

namespace dupin::arrangement {
namespace {

// Cells of 2^-40 of the extent: intervals of a few ulp (2^-52) rarely reach into a second one.
constexpr int kCellBits = 40;
// So many points of a cell are compared with another one each: names are dearer.
constexpr std::size_t kFew = 16;
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
  Sought point{id, {}};
  PointId found = kNone;
  for_each_cell(cells,
                [&](const Cell& cell) { found = found == kNone ? find(point, cell) : found; });
  if (found != kNone) {
    return found;
  }
  for_each_cell(cells, [&](const Cell& cell) { insert(point, cell); });
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

std::size_t CoincidentPointIndex::slot_of(const Cell& cell, std::uint64_t name) const {
  std::uint64_t hash = name;
  for (const std::int64_t x : cell) {
    hash = support::mixed(hash, static_cast<std::uint64_t>(x));
  }
  return static_cast<std::size_t>(hash) & (slots_.size() - 1);
}

template <class Visit>
void CoincidentPointIndex::visit_entries(const Cell& cell, std::uint64_t name,
                                         Visit&& visit) const {
  for (std::uint32_t i = slots_[slot_of(cell, name)]; i != kNone; i = entries_[i].next) {
    const Entry& entry = entries_[i];
    if (entry.cell == cell && entry.name == name && visit(entry)) {
      return;
    }
  }
}

PointId CoincidentPointIndex::find(Sought& point, const Cell& cell) const {
  PointId found = kNone;
  std::size_t count = 0;
  const auto is_it = [&](const Entry& entry) {
    ++count;
    found = coincide(*points_, entry.point, point.id) ? entry.point : kNone;
    return found != kNone;
  };
  visit_entries(cell, 0, is_it);
  if (found != kNone || count < kFew) {
    return found;
  }
  if (const std::uint64_t name = name_of(point); name != 0) {
    visit_entries(cell, name, is_it);
  } else {
    static_cast<void>(std::ranges::any_of(entries_, [&](const Entry& entry) {
      return entry.cell == cell && entry.name != 0 && is_it(entry);
    }));
  }
  return found;
}

bool CoincidentPointIndex::is_crowded(const Cell& cell) const {
  std::size_t count = 0;
  visit_entries(cell, 0, [&](const Entry&) { return ++count == kFew; });
  return count == kFew;
}

std::uint64_t CoincidentPointIndex::name_of(Sought& point) const {
  if (!point.name) {
    const auto residues = exact::residues(points_->exact_value(point.id));
    point.name = 0;
    for (std::size_t k = 0; residues && k < 3; ++k) {
      point.name = support::mixed(*point.name, (*residues)[k]);
    }
  }
  return *point.name;
}

void CoincidentPointIndex::insert(Sought& point, const Cell& cell) {
  entries_.push_back({cell, is_crowded(cell) ? name_of(point) : 0, point.id, kNone});
  if (entries_.size() <= slots_.size()) {
    put_in_slot(static_cast<std::uint32_t>(entries_.size() - 1));
    return;
  }
  slots_.assign(2 * slots_.size(), kNone);
  for (std::uint32_t i = 0; i < entries_.size(); ++i) {
    put_in_slot(i);
  }
}

void CoincidentPointIndex::put_in_slot(std::uint32_t index) {
  Entry& entry = entries_[index];
  std::uint32_t& head = slots_[slot_of(entry.cell, entry.name)];
  entry.next = head;
  head = index;
}

}  // namespace dupin::arrangement
