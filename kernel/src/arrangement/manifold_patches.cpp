#include "arrangement/manifold_patches.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "support/sort_by_key.h"

namespace dupin::arrangement {
namespace {

template <class List>
void append(std::vector<List>& lists, std::vector<List> more) {
  std::ranges::move(more, std::back_inserter(lists));
}

}  // namespace

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
  SideLists sides;
  add_sub_triangles(sides);
  add_outlines(sides);
  add_triangles(rule, sides);
  add_loose(rule, sides);
  join(std::move(sides));
  number_patches(rule);
}

std::uint32_t ManifoldPatches::member_of_triangle(std::uint32_t triangle) const {
  for (const PointId id : input_.triangles[triangle]) {
    if (!input_.special[id]) {
      return id;
    }
  }
  return first_loose_ +
         static_cast<std::uint32_t>(std::lower_bound(loose_.begin(), loose_.end(), triangle) -
                                    loose_.begin());
}

std::uint32_t ManifoldPatches::change_number(std::vector<int> change) {
  const auto [entry, is_new] =
      change_numbers_.emplace(change, static_cast<std::uint32_t>(all_changes_.size()));
  if (is_new) {
    all_changes_.push_back(std::move(change));
  }
  return entry->second;
}

// Of those edges (bit i: opposite to corner i) whose ends are both special.
void ManifoldPatches::add_sides(const Triangle& corners, unsigned edges, const Owner& owner,
                                std::vector<Side>& sides) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const PointId apex = corners[k], from = corners[(k + 1) % 3], to = corners[(k + 2) % 3];
    if ((edges >> k & 1u) != 0 && input_.special[from] && input_.special[to]) {
      const HalfPlane half_plane{apex, owner.support, from < to, owner.member};
      sides.push_back({edge_key(from, to), half_plane, owner.change});
    }
  }
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

void ManifoldPatches::add_sub_triangles(SideLists& sides) {
  const auto add = [this](std::size_t p, std::vector<Side>& found) {
    const Subdivision::SubTriangle& triangle = subdivision_.triangles[p];
    const std::uint32_t member = first_region_ + triangle.region;
    for (const PointId corner : triangle.corners) {
      if (!input_.special[corner]) {
        classes_.unite(corner, member);
      }
    }
    add_sides(
        triangle.corners, triangle.open,
        {member, subdivision_.regions[triangle.region].support, member_changes_[triangle.region]},
        found);
  };
  append(sides, support::collect_by_blocks<Side>(subdivision_.triangles.size(), add));
}

void ManifoldPatches::add_outlines(SideLists& sides) {
  const auto add = [this](std::size_t i, std::vector<Side>& found) {
    const auto& [region, begin, end] = subdivision_.outlines[i];
    const std::uint32_t member = first_region_ + region;
    for (std::uint32_t k = begin; k < end; ++k) {
      const auto& [from, apex, lines] = subdivision_.outline_corners[k];
      const PointId to = subdivision_.outline_corners[k + 1 < end ? k + 1 : begin].point;
      if (!input_.special[from]) {
        classes_.unite(from, member);
      } else if (input_.special[to]) {
        const HalfPlane half_plane{apex, subdivision_.regions[region].support, from < to, member};
        found.push_back({edge_key(from, to), half_plane, member_changes_[region]});
      }
    }
  };
  append(sides, support::collect_by_blocks<Side>(subdivision_.outlines.size(), add));
}

// Triangles with a corner that is not special coincide with no other.
void ManifoldPatches::add_triangles(const BooleanRule& rule, SideLists& sides) {
  struct Found {
    std::vector<std::uint32_t> loose;
    std::vector<Side> sides;
  };
  std::vector<Found> found(support::block_count(input_.triangles.size()));
  support::for_each_block(input_.triangles.size(), [&](const support::Block& block) {
    Found& mine = found[block.number];
    for (auto t = static_cast<std::uint32_t>(block.begin); t < block.end; ++t) {
      if (subdivision_.touched[t] || input_.merged[t]) {
        continue;
      }
      const Triangle& corners = input_.triangles[t];
      PointId member = kNone;
      unsigned special = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        if (input_.special[corners[k]]) {
          ++special;
        } else if (member == kNone) {
          member = corners[k];
        } else {
          classes_.unite(corners[k], member);
        }
      }
      if (special == 3) {
        mine.loose.push_back(t);
      } else if (special == 2) {
        const std::uint32_t change = rule.group_of_operand[input_.operand_of(t)];
        add_sides(corners, kAllEdges, {member, t, change}, mine.sides);
      }
    }
  });
  for (Found& part : found) {
    loose_.insert(loose_.end(), part.loose.begin(), part.loose.end());
    sides.push_back(std::move(part.sides));
  }
}

void ManifoldPatches::add_loose(const BooleanRule& rule, SideLists& sides) {
  std::vector<Side>& found = sides.emplace_back();
  classes_.add(loose_.size());
  for (std::uint32_t i = 0; i < loose_.size(); ++i) {
    const std::uint32_t t = loose_[i];
    member_changes_.push_back(change_number(winding_change(input_, rule, input_.cover(t))));
    add_sides(input_.triangles[t], kAllEdges, {first_loose_ + i, t, member_changes_.back()}, found);
  }
}

void ManifoldPatches::join(SideLists sides) {
  sides_ = support::sorted_by_key(
      std::move(sides), input_.points.size(), [](const Side& side) { return lower_end(side.edge); },
      [](const Side& a, const Side& b) {
        return std::tie(a.edge, a.half_plane.owner, a.half_plane.apex) <
               std::tie(b.edge, b.half_plane.owner, b.half_plane.apex);
      });
  const std::vector<support::IndexRange> edges =
      support::ranges_of_equal(sides_, [](const Side& side) { return side.edge; });
  seams_ = support::collect_in_order<support::IndexRange>(
      edges.size(), [&](std::size_t i, std::vector<support::IndexRange>& seams) {
        const auto [begin, end] = edges[i];
        const Side &first = sides_[begin], &last = sides_[end - 1];
        if (end == begin + 2 && first.half_plane.forward != last.half_plane.forward &&
            first.change == last.change) {
          classes_.unite(first.half_plane.owner, last.half_plane.owner);
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
    changes_[rank] = m >= first_region_
                         ? member_changes_[m - first_region_]
                         : rule.group_of_operand[input_.operand_of_point(static_cast<PointId>(m))];
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
