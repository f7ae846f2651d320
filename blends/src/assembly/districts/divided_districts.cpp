#include "assembly/districts/divided_districts.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "assembly/cost_limit.h"
#include "assembly/districts/common_rings.h"
#include "assembly/groups.h"
#include "assembly/welded_runs.h"

namespace dupin::assembly {
namespace {

/// A ring at which a district may be divided: the two parts that share it, by their places in the
/// district, lowest first.
struct SharedRing {
  std::array<std::uint32_t, 2> parts{};
  std::array<EndIndex, 2> ends{};
  std::string name;
};

/// Of a fillet's ball, in its radii, and as much again as it takes to be sure.
constexpr double kReach = 3;

std::string seam_name(const ResolvedPart& part, End end) {
  // No part is called so: names have no control characters.
  return "\x1f" + to_string({part.name, end});
}

class Divider {
 public:
  Divider(const Assembly& assembly, const ResolvedAssembly& resolved, const Division& division)
      : assembly_(assembly),
        resolved_(resolved),
        division_(division),
        distances_(distances_between(assembly, resolved, division.region)) {}

  void add(DistrictParts members) {
    if (members.parts.size() < kLeastParts) {
      districts_.push_back(std::move(members));
      return;
    }
    const District whole = district_with_loops(assembly_, resolved_, members);
    if (!(expected_triangles(whole, division_.region) > division_.most)) {
      districts_.push_back(std::move(members));
      return;
    }
    const Boxes boxes = close_boxes(members);
    const std::vector<SharedRing> rings = dividing_rings(members, boxes);
    if (rings.empty()) {
      districts_.push_back(std::move(members));
      return;
    }
    append(members, boxes, rings, common_rings(whole, division_.region));
  }

  DividedDistricts take() {
    std::vector<std::uint32_t> order(districts_.size()), place(districts_.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    const auto first = [&](std::uint32_t i) {
      return districts_[i].parts.empty() ? std::uint32_t(resolved_.parts.size())
                                         : districts_[i].parts.front();
    };
    std::ranges::stable_sort(order, {}, first);
    DividedDistricts result;
    for (const std::uint32_t i : order) {
      place[i] = std::uint32_t(result.districts.size());
      result.districts.push_back(std::move(districts_[i]));
    }
    for (Seam& seam : seams_) {
      for (std::uint32_t& piece : seam.pieces) {
        piece = place[piece];
      }
      std::ranges::sort(seam.pieces);
      result.seams.push_back(std::move(seam));
    }
    return result;
  }

 private:
  // A point of a fillet is on a ball that touches both pipes: by no more than its diameter away
  // from either.
  [[nodiscard]] Boxes close_boxes(const DistrictParts& members) const {
    Boxes boxes = members.boxes;
    for (std::size_t i = 0; i < members.fillets.size(); ++i) {
      const ResolvedFillet& fillet = resolved_.fillets[members.fillets[i]];
      const Eigen::AlignedBox3d one = box_of(members, boxes, fillet.between[0]),
                                other = box_of(members, boxes, fillet.between[1]);
      if (one.intersects(other)) {
        const double reach = kReach * fillet.shape.radius;
        boxes[members.parts.size() + i] = widened(one, reach).intersection(widened(other, reach));
      }
    }
    return boxes;
  }

  static Eigen::AlignedBox3d box_of(const DistrictParts& members, const Boxes& boxes,
                                    std::uint32_t part) {
    const auto place = std::ranges::lower_bound(members.parts, part) - members.parts.begin();
    return boxes[std::size_t(place)];
  }

  static Eigen::AlignedBox3d widened(const Eigen::AlignedBox3d& box, double by) {
    return {box.min().array() - by, box.max().array() + by};
  }

  [[nodiscard]] std::vector<SharedRing> rings_of(const DistrictParts& members) const {
    std::vector<SharedRing> result;
    std::map<std::array<std::uint32_t, 2>, int> times;
    for (std::uint32_t i = 0; i < members.parts.size(); ++i) {
      const ResolvedPart& part = resolved_.parts[members.parts[i]];
      for (const End end : {End::start, End::end}) {
        const auto& next = part.joined.at(at(end));
        if (!next || next->part <= members.parts[i]) {
          continue;
        }
        const auto place = std::ranges::lower_bound(members.parts, next->part);
        const auto other = std::uint32_t(place - members.parts.begin());
        ++times[{i, other}];
        result.push_back(
            {{i, other}, {EndIndex{members.parts[i], end}, *next}, seam_name(part, end)});
      }
    }
    std::erase_if(result, [&](const SharedRing& ring) {
      return times[ring.parts] > 1 || division_.kept.contains(ring.name) ||
             !ends_alike(resolved_, ring.ends[0], distances_, division_.region);
    });
    std::ranges::sort(result, {}, &SharedRing::parts);
    return result;
  }

  // Those between things that nothing else holds together.
  [[nodiscard]] std::vector<SharedRing> dividing_rings(const DistrictParts& members,
                                                       const Boxes& boxes) {
    std::vector<SharedRing> rings = rings_of(members);
    std::vector<std::array<std::uint32_t, 2>> pairs;
    pairs.reserve(rings.size());
    for (const SharedRing& ring : rings) {
      pairs.push_back(ring.parts);
    }
    atom_of_ = districts_of(boxes, pairs);
    std::erase_if(rings, [&](const SharedRing& ring) {
      return atom_of_[ring.parts[0]] == atom_of_[ring.parts[1]];
    });
    return rings;
  }

  // What goes into each group, by the place of its first thing among all; all in order.
  [[nodiscard]] std::vector<DistrictParts> pieces(const DistrictParts& members, const Boxes& boxes,
                                                  std::span<const std::uint32_t> group_of,
                                                  std::size_t count, const PieceOf& common) const {
    std::vector<DistrictParts> result(count);
    for (DistrictParts& piece : result) {
      piece.piece.emplace();
      piece.piece->grid = common.grid;
      piece.piece->tolerance = common.tolerance;
    }
    const std::size_t parts = members.parts.size(), fillets = members.fillets.size();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      DistrictParts& own = result[group_of[i]];
      own.boxes.push_back(boxes[i]);
      if (i < parts) {
        own.parts.push_back(members.parts[i]);
        own.piece->samplings.push_back(common.samplings[i]);
        own.piece->second_samplings.push_back(common.second_samplings[i]);
      } else if (i < parts + fillets) {
        own.fillets.push_back(members.fillets[i - parts]);
      } else {
        own.junctions.push_back(members.junctions[i - parts - fillets]);
      }
    }
    return result;
  }

  void add_discs(std::span<const SharedRing> rings, std::span<const std::uint32_t> group_of,
                 std::vector<DistrictParts>& pieces) const {
    for (const SharedRing& ring : rings) {
      for (std::size_t side = 0; side < 2; ++side) {
        pieces[group_of[ring.parts.at(side)]].piece->discs.push_back(
            {ring.ends.at(side), ring.name});
      }
    }
  }

  [[nodiscard]] std::vector<double> expected(const std::vector<DistrictParts>& pieces) const {
    std::vector<double> result;
    result.reserve(pieces.size());
    for (const DistrictParts& piece : pieces) {
      result.push_back(
          expected_triangles(district_with_loops(assembly_, resolved_, piece), division_.region));
    }
    return result;
  }

  void append(const DistrictParts& members, const Boxes& boxes, std::span<const SharedRing> rings,
              const PieceOf& common) {
    const std::size_t atoms = 1 + std::size_t(*std::ranges::max_element(atom_of_));
    std::vector<DistrictParts> parts = pieces(members, boxes, atom_of_, atoms, common);
    add_discs(rings, atom_of_, parts);
    std::vector<double> triangles = expected(parts);
    Groups groups(atoms);
    for (const SharedRing& ring : rings) {
      const std::uint32_t a = groups.of(atom_of_[ring.parts[0]]),
                          b = groups.of(atom_of_[ring.parts[1]]);
      if (a != b && triangles[a] + triangles[b] <= division_.most) {
        triangles[std::min(a, b)] = triangles[a] + triangles[b];
        groups.unite(a, b);
      }
    }
    append_groups(members, boxes, rings, common, groups);
  }

  void append_groups(const DistrictParts& members, const Boxes& boxes,
                     std::span<const SharedRing> rings, const PieceOf& common, Groups& groups) {
    std::map<std::uint32_t, std::uint32_t> number;  // of the group, by its first atom
    std::vector<std::uint32_t> group_of;
    for (const std::uint32_t atom : atom_of_) {
      const auto next = std::uint32_t(number.size());
      group_of.push_back(number.try_emplace(groups.of(atom), next).first->second);
    }
    if (number.size() == 1) {
      districts_.push_back(members);
      return;
    }
    std::vector<SharedRing> left;
    std::ranges::copy_if(rings, std::back_inserter(left), [&](const SharedRing& ring) {
      return group_of[ring.parts[0]] != group_of[ring.parts[1]];
    });
    auto made = pieces(members, boxes, group_of, number.size(), common);
    add_discs(left, group_of, made);
    const auto first = std::uint32_t(districts_.size());
    for (const SharedRing& ring : left) {
      seams_.push_back({{first + group_of[ring.parts[0]], first + group_of[ring.parts[1]]},
                        ring.name,
                        boxes[ring.parts[0]].intersection(boxes[ring.parts[1]])});
    }
    std::ranges::move(made, std::back_inserter(districts_));
  }

  const Assembly& assembly_;
  const ResolvedAssembly& resolved_;
  const Division& division_;
  std::optional<std::vector<double>> distances_;  // of second surfaces, by place in the document
  std::vector<std::uint32_t> atom_of_;            // of the district that is divided, by box
  std::vector<DistrictParts> districts_;
  std::vector<Seam> seams_;
};

}  // namespace

ExpectedTriangles expected_of(const District& own) {
  const std::vector<WeldedRun> runs = welded_runs(own.resolved);
  const double grid = own.piece ? own.piece->grid : lattice_spacing(own.assembly, own.resolved);
  const std::span<const RingSampling> given =
      own.piece ? std::span<const RingSampling>(own.piece->samplings)
                : std::span<const RingSampling>();
  return {expected_triangles(own.assembly, own.resolved, runs, grid, given),
          expected_crossings(own.assembly, own.resolved, runs, grid, given)};
}

double expected_triangles(const District& own, std::optional<Region> region) {
  const auto [surface, crossings] = expected_of(own);
  const auto distances = distances_between(own.assembly, own.resolved, region);
  const bool has_second =
      distances && std::ranges::any_of(*distances, [](double distance) { return distance > 0; });
  // These surfaces have about as many triangles as the first ones, and cross those of others, too.
  return has_second || region == Region::insulation ? 2 * surface + 4 * crossings
                                                    : surface + crossings;
}

DividedDistricts divided(const Assembly& assembly, const ResolvedAssembly& resolved,
                         std::vector<DistrictParts> districts, const Division& division) {
  Divider divider(assembly, resolved, division);
  for (DistrictParts& members : districts) {
    divider.add(std::move(members));
  }
  return divider.take();
}

}  // namespace dupin::assembly
