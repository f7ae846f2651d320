#include "assembly/districts/dividing_rings.h"

#include <algorithm>
#include <map>

#include "assembly/districts/common_rings.h"
#include "assembly/districts/pipe_stretches.h"
#include "dupin/kernel/districts.h"

namespace dupin::assembly {
namespace {

/// Of a fillet's ball, in its radii, and as much again as it takes to be sure.
constexpr double kReach = 3;

std::string seam_name(const ResolvedPart& part, End end) {
  return is_cut(part, end) ? part.end_names.at(at(end)) : kSeamMark + to_string({part.name, end});
}

Eigen::AlignedBox3d widened(const Eigen::AlignedBox3d& box, double by) {
  return {box.min().array() - by, box.max().array() + by};
}

// A point of a fillet is on a ball that touches both pipes: by no more than its diameter away from
// either.
Boxes close_boxes(const Divisible& whole) {
  const DistrictParts& members = whole.members;
  Boxes boxes = members.boxes;
  for (std::size_t i = 0; i < members.fillets.size(); ++i) {
    const ResolvedFillet& fillet = whole.resolved.fillets[members.fillets[i]];
    const Eigen::AlignedBox3d one = members.boxes[members.place_of(fillet.between[0])],
                              other = members.boxes[members.place_of(fillet.between[1])];
    if (one.intersects(other)) {
      const double reach = kReach * fillet.shape.radius;
      boxes[members.parts.size() + i] = widened(one, reach).intersection(widened(other, reach));
    }
  }
  return boxes;
}

std::vector<SharedRing> rings_of(const Divisible& whole, const DividingRule& rule) {
  const DistrictParts& members = whole.members;
  std::vector<SharedRing> result;
  std::map<std::array<std::uint32_t, 2>, int> times;
  for (std::uint32_t i = 0; i < members.parts.size(); ++i) {
    const ResolvedPart& part = whole.resolved.parts[members.parts[i]];
    for (const End end : {End::start, End::end}) {
      const auto& next = part.joined.at(at(end));
      if (!next || next->part <= members.parts[i]) {
        continue;
      }
      const std::uint32_t other = members.place_of(next->part);
      ++times[{i, other}];
      result.push_back(
          {{i, other}, {EndIndex{members.parts[i], end}, *next}, seam_name(part, end)});
    }
  }
  std::erase_if(result, [&](const SharedRing& ring) {
    return times[ring.parts] > 1 || rule.kept.contains(ring.name) ||
           !ends_alike(whole.resolved, ring.ends[0], rule.distances, rule.region);
  });
  std::ranges::sort(result, {}, &SharedRing::parts);
  return result;
}

}  // namespace

Atoms atoms_of(const Divisible& whole, const DividingRule& rule) {
  Atoms result{close_boxes(whole), rings_of(whole, rule), {}, 0};
  std::vector<std::array<std::uint32_t, 2>> pairs;
  pairs.reserve(result.rings.size());
  for (const SharedRing& ring : result.rings) {
    pairs.push_back(ring.parts);
  }
  // Those between things that nothing else holds together.
  result.of = districts_of(result.boxes, pairs);
  std::erase_if(result.rings, [&](const SharedRing& ring) {
    return result.of[ring.parts[0]] == result.of[ring.parts[1]];
  });
  result.count = result.of.empty() ? 0 : 1 + std::size_t(*std::ranges::max_element(result.of));
  return result;
}

std::vector<DistrictParts> pieces_of(const Divisible& whole, const Boxes& boxes,
                                     std::span<const SharedRing> rings,
                                     std::span<const std::uint32_t> group_of) {
  const auto& [resolved, members, common] = whole;
  std::vector<DistrictParts> result(group_of.empty() ? 0 : 1 + *std::ranges::max_element(group_of));
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
  for (const SharedRing& ring : rings) {
    if (group_of[ring.parts[0]] != group_of[ring.parts[1]]) {
      for (std::size_t side = 0; side < 2; ++side) {
        result[group_of[ring.parts.at(side)]].piece->discs.push_back(
            {ring.ends.at(side), ring.name});
      }
    }
  }
  return result;
}

}  // namespace dupin::assembly
