#include "assembly/district_plan.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "assembly/part_box.h"

namespace dupin::assembly {
namespace {

// Of parts, then of fillets, then of junctions.
Boxes boxes_of(const ResolvedAssembly& resolved, double margin, double relative) {
  Boxes boxes;
  for (const ResolvedPart& part : resolved.parts) {
    boxes.push_back(part_box(part.shape));
  }
  for (const ResolvedFillet& fillet : resolved.fillets) {
    boxes.push_back(boxes[fillet.between[0]].merged(boxes[fillet.between[1]]));
  }
  for (const ResolvedJunction& junction : resolved.junctions) {
    boxes.push_back(part_box(junction.shape.hub));
  }
  const Eigen::AlignedBox3d all = bounds_of(std::span(&boxes, 1));
  const double largest = boxes.empty() ? 0 : std::max(all.max().maxCoeff(), -all.min().minCoeff());
  const double whole = margin + relative * std::max(largest, 0.0);
  for (Eigen::AlignedBox3d& box : boxes) {
    box = {box.min().array() - whole, box.max().array() + whole};
  }
  return boxes;
}

/// The place of each of some among them.
std::map<std::uint32_t, std::uint32_t> places_of(const std::vector<std::uint32_t>& some) {
  std::map<std::uint32_t, std::uint32_t> places;
  for (const std::uint32_t one : some) {
    places.emplace(one, static_cast<std::uint32_t>(places.size()));
  }
  return places;
}

class Selection {
 public:
  Selection(const Assembly& assembly, const ResolvedAssembly& whole, const DistrictParts& members)
      : whole_(whole), members_(members) {
    for (const auto part : members.parts) {
      result_.parts.push_back(whole.parts[part].index);
    }
    for (const auto fillet : members.fillets) {
      result_.parts.push_back(whole.fillets[fillet].index);
    }
    for (const auto junction : members.junctions) {
      result_.parts.push_back(whole.junctions[junction].index);
    }
    std::ranges::sort(result_.parts);
    result_.parts.erase(std::unique(result_.parts.begin(), result_.parts.end()),
                        result_.parts.end());
    take_document(assembly);
  }

  District run() {
    const auto said = places_of(result_.parts), kept = places_of(members_.parts);
    for (const auto position : members_.parts) {
      ResolvedPart part = whole_.parts[position];
      part.index = said.at(part.index);
      for (std::optional<EndIndex>& joined : part.joined) {
        joined = joined ? std::optional(EndIndex{kept.at(joined->part), joined->end}) : joined;
      }
      result_.resolved.parts.push_back(std::move(part));
    }
    for (const auto position : members_.fillets) {
      ResolvedFillet fillet = whole_.fillets[position];
      fillet.index = said.at(fillet.index);
      for (std::uint32_t& part : fillet.between) {
        part = kept.at(part);
      }
      result_.resolved.fillets.push_back(std::move(fillet));
    }
    for (const auto position : members_.junctions) {
      ResolvedJunction junction = whole_.junctions[position];
      junction.index = said.at(junction.index);
      for (std::uint32_t& arm : junction.arms) {
        arm = kept.at(arm);
      }
      result_.resolved.junctions.push_back(std::move(junction));
    }
    return std::move(result_);
  }

 private:
  void take_document(const Assembly& assembly) {
    Assembly& own = result_.assembly;
    own.source = assembly.source;
    own.unit = assembly.unit;
    own.tolerance = assembly.tolerance;
    own.segments = assembly.segments;
    own.wall = assembly.wall;
    own.wall_side = assembly.wall_side;
    own.insulation = assembly.insulation;
    own.patches = assembly.patches;
    for (const std::uint32_t index : result_.parts) {
      own.parts.push_back(assembly.parts[index]);
      if (own.parts.back().pointer.empty()) {
        own.parts.back().pointer = "/parts/" + std::to_string(index);
      }
    }
  }

  const ResolvedAssembly& whole_;
  const DistrictParts& members_;
  District result_;
};

}  // namespace

std::vector<DistrictParts> districts_of_parts(const ResolvedAssembly& resolved, double margin,
                                              double relative) {
  const Boxes boxes = boxes_of(resolved, margin, relative);
  const std::vector<std::uint32_t> number = districts_of(boxes);
  std::vector<DistrictParts> result;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (number[i] == result.size()) {
      result.emplace_back();
    }
    DistrictParts& own = result[number[i]];
    own.boxes.push_back(boxes[i]);
    const std::size_t fillet = i - resolved.parts.size(),
                      junction = fillet - resolved.fillets.size();
    if (i < resolved.parts.size()) {
      own.parts.push_back(i);
    } else if (fillet < resolved.fillets.size()) {
      own.fillets.push_back(static_cast<std::uint32_t>(fillet));
    } else {
      own.junctions.push_back(static_cast<std::uint32_t>(junction));
    }
  }
  return result;
}

District district(const Assembly& assembly, const ResolvedAssembly& resolved,
                  const DistrictParts& members) {
  return Selection(assembly, resolved, members).run();
}

}  // namespace dupin::assembly
