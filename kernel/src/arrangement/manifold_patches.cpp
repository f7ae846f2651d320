#include "arrangement/manifold_patches.h"

#include <algorithm>
#include <tuple>

#include "support/sort_by_key.h"

namespace dupin::arrangement {

ManifoldPatches::ManifoldPatches(const ArrangementInput& input, const BooleanRule& rule,
                                 const Subdivision& subdivision)
    : input_(input),
      subdivision_(subdivision),
      first_region_(input.points.size()),
      first_loose_(first_region_ + static_cast<std::uint32_t>(subdivision.regions.size())),
      classes_(first_loose_) {
  for (std::uint32_t g = 0; g < rule.groups; ++g) {
    std::vector<int> unit(rule.groups, 0);
    unit[g] = 1;
    (void)change_number(std::move(unit));
  }
  find_changes_of_regions(rule);
  join_corners();
  find_loose(rule);
  join_sides(rule);
  number_patches(rule);
}

PointId ManifoldPatches::first_not_special(std::uint32_t triangle) const {
  const Triangle& corners = input_.triangles[triangle];
  const auto* const found =
      std::ranges::find_if(corners, [this](PointId id) { return !input_.special[id]; });
  return found == corners.end() ? kNone : *found;
}

std::uint32_t ManifoldPatches::member_of_triangle(std::uint32_t triangle) const {
  const PointId point = first_not_special(triangle);
  return point != kNone
             ? point
             : first_loose_ + static_cast<std::uint32_t>(
                                  std::ranges::lower_bound(loose_, triangle) - loose_.begin());
}

std::uint32_t ManifoldPatches::change_number(std::vector<int> change) {
  const auto [entry, is_new] =
      change_numbers_.emplace(change, static_cast<std::uint32_t>(all_changes_.size()));
  if (is_new) {
    all_changes_.push_back(std::move(change));
  }
  return entry->second;
}

std::uint32_t ManifoldPatches::change_of(const BooleanRule& rule, std::uint32_t member) const {
  return member >= first_region_ ? member_changes_[member - first_region_]
                                 : rule.group_of_operand[input_.operand_of_point(member)];
}

void ManifoldPatches::find_changes_of_regions(const BooleanRule& rule) {
  for (std::uint32_t r = 0; r < subdivision_.regions.size(); ++r) {
    const bool is_known =
        r > 0 && subdivision_.regions[r].first_cover == subdivision_.regions[r - 1].first_cover;
    member_changes_.push_back(
        is_known ? member_changes_.back()
                 : change_number(winding_change(input_, rule, subdivision_.cover(r))));
  }
}

// Corners that are not special are of the class of what they are corners of.
void ManifoldPatches::join_corners() {
  const auto join = [this](PointId corner, std::uint32_t member) {
    if (corner != member && !input_.special[corner]) {
      classes_.unite(corner, member);
    }
  };
  const auto for_each = [](std::size_t count, const auto& visit) {
    support::for_each_block(count, [&](const support::Block& block) {
      for (auto i = static_cast<std::uint32_t>(block.begin); i < block.end; ++i) {
        visit(i);
      }
    });
  };
  for_each(subdivision_.triangles.size(), [&](std::uint32_t i) {
    const Subdivision::SubTriangle& triangle = subdivision_.triangles[i];
    for (const PointId corner : triangle.corners) {
      join(corner, first_region_ + triangle.region);
    }
  });
  for_each(subdivision_.outlines.size(), [&](std::uint32_t i) {
    const auto& [region, begin, end] = subdivision_.outlines[i];
    for (std::uint32_t k = begin; k < end; ++k) {
      join(subdivision_.outline_corners[k].point, first_region_ + region);
    }
  });
  bordering_ = support::collect_in_order<std::uint32_t>(
      input_.triangles.size(), [&](std::size_t i, std::vector<std::uint32_t>& bordering) {
        const auto t = static_cast<std::uint32_t>(i);
        if (subdivision_.touched[t] || input_.merged[t]) {
          return;
        }
        const PointId first = first_not_special(t);
        int special = 0;
        for (const PointId corner : input_.triangles[t]) {
          special += input_.special[corner] ? 1 : 0;
          join(corner, first);
        }
        if (special >= 2) {
          bordering.push_back(t);
        }
      });
}

// Triangles with a corner that is not special coincide with no other.
void ManifoldPatches::find_loose(const BooleanRule& rule) {
  const auto loose =
      std::stable_partition(bordering_.begin(), bordering_.end(),
                            [this](std::uint32_t t) { return first_not_special(t) != kNone; });
  loose_.assign(loose, bordering_.end());
  bordering_.erase(loose, bordering_.end());
  classes_.add(loose_.size());
  for (const std::uint32_t t : loose_) {
    member_changes_.push_back(change_number(winding_change(input_, rule, input_.cover(t))));
  }
}

// Calls found(side) for the edges (bit i: opposite to corner i) whose ends are both special.
template <class Found>
void ManifoldPatches::find_sides(const Triangle& corners, unsigned edges, std::uint32_t support,
                                 std::uint32_t member, const Found& found) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const PointId apex = corners[k], from = corners[(k + 1) % 3], to = corners[(k + 2) % 3];
    if ((edges >> k & 1u) != 0 && input_.special[from] && input_.special[to]) {
      found(Side{edge_key(from, to), HalfPlane{apex, support, from < to, member}});
    }
  }
}

template <class Found>
void ManifoldPatches::find_sides_of_outline(std::size_t outline, const Found& found) const {
  const auto& [region, begin, end] = subdivision_.outlines[outline];
  const std::uint32_t support = subdivision_.regions[region].support;
  for (std::uint32_t k = begin; k < end; ++k) {
    const auto& [from, apex, lines] = subdivision_.outline_corners[k];
    const PointId to = subdivision_.outline_corners[k + 1 < end ? k + 1 : begin].point;
    if (input_.special[from] && input_.special[to]) {
      found(Side{edge_key(from, to), HalfPlane{apex, support, from < to, first_region_ + region}});
    }
  }
}

support::BulkVector<ManifoldPatches::Side> ManifoldPatches::sorted_sides() const {
  constexpr unsigned kAllEdges = 7;
  const std::size_t outlines = subdivision_.triangles.size();
  const std::size_t whole = outlines + subdivision_.outlines.size();
  const std::size_t loose = whole + bordering_.size();
  const auto collect = [&](std::size_t i, const auto& found) {
    if (i < outlines) {
      const auto& [corners, region, open] = subdivision_.triangles[i];
      find_sides(corners, open, subdivision_.regions[region].support, first_region_ + region,
                 found);
    } else if (i < whole) {
      find_sides_of_outline(i - outlines, found);
    } else if (i < loose) {
      const std::uint32_t t = bordering_[i - whole];
      find_sides(input_.triangles[t], kAllEdges, t, first_not_special(t), found);
    } else {
      const auto number = static_cast<std::uint32_t>(i - loose);
      const std::uint32_t t = loose_[number];
      find_sides(input_.triangles[t], kAllEdges, t, first_loose_ + number, found);
    }
  };
  return support::collect_by_key<Side>(
      loose + loose_.size(), collect, input_.points.size(),
      [](const Side& side) { return lower_end(side.edge); },
      [](const Side& a, const Side& b) {
        return std::tie(a.edge, a.half_plane.owner, a.half_plane.apex) <
               std::tie(b.edge, b.half_plane.owner, b.half_plane.apex);
      });
}

void ManifoldPatches::join_sides(const BooleanRule& rule) {
  sides_ = sorted_sides();
  const std::vector<support::IndexRange> edges =
      support::ranges_of_equal(sides_, [](const Side& side) { return side.edge; });
  seams_ = support::collect_in_order<support::IndexRange>(
      edges.size(), [&](std::size_t i, std::vector<support::IndexRange>& seams) {
        const auto [begin, end] = edges[i];
        const HalfPlane &first = sides_[begin].half_plane, &last = sides_[end - 1].half_plane;
        if (end == begin + 2 && first.forward != last.forward &&
            change_of(rule, first.owner) == change_of(rule, last.owner)) {
          classes_.unite(first.owner, last.owner);
        } else {
          seams.push_back({begin, end});
        }
      });
}

void ManifoldPatches::number_patches(const BooleanRule& rule) {
  number_.resize(first_loose_ + loose_.size());
  const auto is_used = [this](std::size_t m) { return m >= first_region_ || !input_.special[m]; };
  const support::Ranking roots(number_.size(), [&](std::size_t m) {
    const auto member = static_cast<std::uint32_t>(m);
    return is_used(m) && classes_.find(member) == member;
  });
  changes_.resize(roots.size());
  roots.for_each([&](std::size_t m, std::size_t rank) {
    number_[m] = static_cast<std::uint32_t>(rank);
    changes_[rank] = change_of(rule, static_cast<std::uint32_t>(m));
  });
  support::for_each_block(number_.size(), [&](const support::Block& block) {
    for (auto m = static_cast<std::uint32_t>(block.begin); m < block.end; ++m) {
      const std::uint32_t root = is_used(m) ? classes_.find(m) : m;
      if (root != m) {
        number_[m] = number_[root];
      }
    }
  });
}

}  // namespace dupin::arrangement
