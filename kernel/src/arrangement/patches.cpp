#include "patches.h"

#include <algorithm>
#include <tuple>

#include "sort_by_key.h"
#include "winding_change.h"

namespace dupin::detail {

Patches::Patches(const Scene& scene, const BooleanRule& rule, const Incidences& incidences,
                 const Pieces& pieces)
    : scene_(scene),
      incidences_(incidences),
      pieces_(pieces),
      first_region_(scene.points.size()),
      first_loose_(first_region_ + static_cast<std::uint32_t>(pieces.regions.size())),
      classes_(first_loose_) {
  for (std::uint32_t g = 0; g < rule.groups; ++g) {
    std::vector<int> unit(rule.groups, 0);
    unit[g] = 1;
    (void)change_number(std::move(unit));
  }
  find_changes_of_regions(rule);
  add_pieces();
  add_triangles(rule);
  add_loose(rule);
  join_sides();
  number_patches(rule);
}

std::uint32_t Patches::member_of_triangle(std::uint32_t triangle) const {
  for (const PointId id : scene_.triangles[triangle]) {
    if (!scene_.special[id]) {
      return id;
    }
  }
  return first_loose_ +
         static_cast<std::uint32_t>(std::lower_bound(loose_.begin(), loose_.end(), triangle) -
                                    loose_.begin());
}

std::uint32_t Patches::change_number(std::vector<int> change) {
  const auto [place, is_new] =
      change_numbers_.emplace(change, static_cast<std::uint32_t>(all_changes_.size()));
  if (is_new) {
    all_changes_.push_back(std::move(change));
  }
  return place->second;
}

// Of those edges (bit i: opposite to corner i) whose ends are both special.
void Patches::add_sides(const Triangle& corners, unsigned edges, const Owner& owner,
                        std::vector<Side>& sides) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const PointId apex = corners[k], from = corners[(k + 1) % 3], to = corners[(k + 2) % 3];
    if ((edges >> k & 1u) != 0 && scene_.special[from] && scene_.special[to]) {
      const Sheet sheet{apex, owner.support, from < to, owner.member};
      sides.push_back({edge_key(from, to), sheet, owner.change});
    }
  }
}

void Patches::find_changes_of_regions(const BooleanRule& rule) {
  for (std::uint32_t r = 0; r < pieces_.regions.size(); ++r) {
    const bool is_known =
        r > 0 && pieces_.regions[r].first_cover == pieces_.regions[r - 1].first_cover;
    member_changes_.push_back(is_known
                                  ? member_changes_.back()
                                  : change_number(winding_change(scene_, rule, pieces_.cover(r))));
  }
}

void Patches::add_pieces() {
  const auto add = [this](std::size_t p, std::vector<Side>& sides) {
    const Pieces::Piece& piece = pieces_.pieces[p];
    const std::uint32_t member = first_region_ + piece.region;
    for (const PointId corner : piece.corners) {
      if (!scene_.special[corner]) {
        classes_.unite(corner, member);
      }
    }
    add_sides(piece.corners, piece.open,
              {member, pieces_.regions[piece.region].support, member_changes_[piece.region]},
              sides);
  };
  sides_ = collect_in_order<Side>(pieces_.pieces.size(), add);
}

// Triangles with a corner that is not special coincide with no other.
void Patches::add_triangles(const BooleanRule& rule) {
  struct Found {
    std::vector<std::uint32_t> loose;
    std::vector<Side> sides;
  };
  std::vector<Found> found(block_count(scene_.triangles.size()));
  for_each_block(scene_.triangles.size(), [&](const Block& block) {
    Found& mine = found[block.number];
    for (auto t = static_cast<std::uint32_t>(block.begin); t < block.end; ++t) {
      if (incidences_.touched[t] || scene_.merged[t]) {
        continue;
      }
      const Triangle& corners = scene_.triangles[t];
      PointId member = kNone;
      unsigned special = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        if (scene_.special[corners[k]]) {
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
        const std::uint32_t change = rule.group_of_operand[scene_.operand_of(t)];
        add_sides(corners, kAllEdges, {member, t, change}, mine.sides);
      }
    }
  });
  for (const Found& part : found) {
    loose_.insert(loose_.end(), part.loose.begin(), part.loose.end());
    sides_.insert(sides_.end(), part.sides.begin(), part.sides.end());
  }
}

void Patches::add_loose(const BooleanRule& rule) {
  classes_.add(loose_.size());
  for (std::uint32_t i = 0; i < loose_.size(); ++i) {
    const std::uint32_t t = loose_[i];
    member_changes_.push_back(change_number(winding_change(scene_, rule, scene_.cover(t))));
    add_sides(scene_.triangles[t], kAllEdges, {first_loose_ + i, t, member_changes_.back()},
              sides_);
  }
}

void Patches::join_sides() {
  sort_by_key(
      sides_, scene_.points.size(), [](const Side& side) { return lower_end(side.edge); },
      [](const Side& a, const Side& b) {
        return std::tie(a.edge, a.sheet.owner, a.sheet.apex) <
               std::tie(b.edge, b.sheet.owner, b.sheet.apex);
      });
  const std::vector<Run> edges = runs_of_equal(sides_, [](const Side& side) { return side.edge; });
  seams_ = collect_in_order<Run>(edges.size(), [&](std::size_t i, std::vector<Run>& seams) {
    const auto [begin, end] = edges[i];
    const Side &first = sides_[begin], &last = sides_[end - 1];
    if (end == begin + 2 && first.sheet.forward != last.sheet.forward &&
        first.change == last.change) {
      classes_.unite(first.sheet.owner, last.sheet.owner);
    } else {
      seams.push_back({begin, end});
    }
  });
}

void Patches::number_patches(const BooleanRule& rule) {
  number_.resize(first_loose_ + loose_.size());
  const auto is_used = [this](std::size_t m) { return m >= first_region_ || !scene_.special[m]; };
  const Ranking roots(number_.size(), [&](std::size_t m) {
    const auto member = static_cast<std::uint32_t>(m);
    return is_used(m) && classes_.find(member) == member;
  });
  changes_.resize(roots.size());
  roots.for_each([&](std::size_t m, std::size_t rank) {
    number_[m] = static_cast<std::uint32_t>(rank);
    changes_[rank] = m >= first_region_
                         ? member_changes_[m - first_region_]
                         : rule.group_of_operand[scene_.operand_of_point(static_cast<PointId>(m))];
  });
  for_each_block(number_.size(), [&](const Block& block) {
    for (auto m = static_cast<std::uint32_t>(block.begin); m < block.end; ++m) {
      const std::uint32_t root = is_used(m) ? classes_.find(m) : m;
      if (root != m) {
        number_[m] = number_[root];
      }
    }
  });
}

}  // namespace dupin::detail
