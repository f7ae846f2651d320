#include "patches.h"

#include <algorithm>
#include <tuple>

#include "winding_change.h"

namespace dupin::detail {
namespace {

bool is_loose(const Scene& scene, const Triangle& t) {
  return scene.special[t[0]] && scene.special[t[1]] && scene.special[t[2]];
}

std::vector<std::uint32_t> find_loose(const Scene& scene, const Incidences& incidences) {
  std::vector<std::uint32_t> loose;
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    if (!incidences.touched[t] && !scene.merged[t] && is_loose(scene, scene.triangles[t])) {
      loose.push_back(t);
    }
  }
  return loose;
}

}  // namespace

Patches::Patches(const Scene& scene, const BooleanRule& rule, const Incidences& incidences,
                 const Pieces& pieces)
    : scene_(scene),
      incidences_(incidences),
      pieces_(pieces),
      first_region_(scene.points.size()),
      first_loose_(first_region_ + static_cast<std::uint32_t>(pieces.regions.size())),
      loose_(find_loose(scene, incidences)),
      classes_(first_loose_ + loose_.size()) {
  for (std::uint32_t g = 0; g < rule.groups; ++g) {
    std::vector<int> unit(rule.groups, 0);
    unit[g] = 1;
    (void)change_number(std::move(unit));
  }
  add_pieces(rule);
  add_triangles(rule);
  join_sides();
  number_patches();
  find_changes(rule);
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

void Patches::add_side(PointId from, PointId to, const Sheet& sheet, std::uint32_t change) {
  if (scene_.special[from] && scene_.special[to]) {
    sides_.push_back({edge_key(from, to), sheet, change});
  }
}

void Patches::add_pieces(const BooleanRule& rule) {
  for (std::uint32_t r = 0; r < pieces_.regions.size(); ++r) {
    const bool is_known =
        r > 0 && pieces_.regions[r].first_cover == pieces_.regions[r - 1].first_cover;
    member_changes_.push_back(is_known
                                  ? member_changes_.back()
                                  : change_number(winding_change(scene_, rule, pieces_.cover(r))));
  }
  for (const Pieces::Piece& piece : pieces_.pieces) {
    const std::uint32_t member = first_region_ + piece.region;
    for (std::size_t k = 0; k < 3; ++k) {
      const PointId apex = piece.corners[k], from = piece.corners[(k + 1) % 3],
                    to = piece.corners[(k + 2) % 3];
      if ((piece.open >> k & 1u) != 0) {
        add_side(from, to, {apex, pieces_.regions[piece.region].support, from < to, member},
                 member_changes_[piece.region]);
      }
      if (!scene_.special[apex]) {
        classes_.unite(apex, member);
      }
    }
  }
}

void Patches::add_triangles(const BooleanRule& rule) {
  for (std::uint32_t t = 0; t < scene_.triangles.size(); ++t) {
    if (incidences_.touched[t] || scene_.merged[t]) {
      continue;
    }
    const Triangle& corners = scene_.triangles[t];
    const std::uint32_t member = member_of_triangle(t);
    std::uint32_t change = kNone;
    if (member >= first_loose_) {
      change = change_number(winding_change(scene_, rule, scene_.cover(t)));
      member_changes_.push_back(change);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const PointId apex = corners[k], from = corners[(k + 1) % 3], to = corners[(k + 2) % 3];
      if (!scene_.special[apex] && apex != member) {
        classes_.unite(apex, member);
      }
      if (scene_.special[from] && scene_.special[to]) {
        change = change != kNone ? change : rule.group_of_operand[scene_.operand_of(t)];
        add_side(from, to, {apex, t, from < to, member}, change);
      }
    }
  }
}

void Patches::join_sides() {
  std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
    return std::tie(a.edge, a.sheet.owner, a.sheet.apex) <
           std::tie(b.edge, b.sheet.owner, b.sheet.apex);
  });
  for (std::size_t i = 0, end = 0; i < sides_.size(); i = end) {
    end = i + 1;
    while (end < sides_.size() && sides_[end].edge == sides_[i].edge) {
      ++end;
    }
    const Sheet &a = sides_[i].sheet, &b = sides_[end - 1].sheet;
    if (end == i + 2 && a.forward != b.forward && sides_[i].change == sides_[i + 1].change) {
      classes_.unite(a.owner, b.owner);
    } else {
      const auto first = static_cast<std::uint32_t>(sheets_.size());
      for (std::size_t j = i; j < end; ++j) {
        sheets_.push_back(sides_[j].sheet);
      }
      seams_.push_back({sides_[i].edge, first, static_cast<std::uint32_t>(sheets_.size())});
    }
  }
  sides_ = {};
}

void Patches::number_patches() {
  number_.assign(first_loose_ + loose_.size(), kNone);
  for (std::uint32_t m = 0; m < number_.size(); ++m) {
    const bool is_used = m >= first_region_ || !scene_.special[m];
    if (!is_used) {
      continue;
    }
    const std::uint32_t root = classes_.find(m);
    if (number_[root] == kNone) {
      number_[root] = size();
      changes_.push_back(kNone);
    }
    number_[m] = number_[root];
    if (m >= first_region_) {
      changes_[number_[m]] = member_changes_[m - first_region_];
    }
  }
}

// Triangles with a corner that is not special coincide with no other.
void Patches::find_changes(const BooleanRule& rule) {
  for (std::size_t o = 0; o < scene_.operands.size(); ++o) {
    for (std::uint32_t t = scene_.first_triangle[o]; t < scene_.first_triangle[o + 1]; ++t) {
      if (!incidences_.touched[t] && !scene_.merged[t]) {
        std::uint32_t& change = changes_[of_triangle(t)];
        change = change != kNone ? change : rule.group_of_operand[o];
      }
    }
  }
}

}  // namespace dupin::detail
