#include "assembly/districts/district_plan.h"

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "assembly/part_box.h"
#include "assembly/parts/part_kind.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin::assembly {
namespace {

// Of parts, then of fillets, then of junctions.
Boxes boxes_of(const ResolvedAssembly& resolved, double margin, double relative) {
  Boxes boxes(resolved.parts.size());
  for_each_in_parallel(boxes.size(),
                       [&](std::size_t i) { boxes[i] = part_box(resolved.parts[i].shape); });
  for (const ResolvedFillet& fillet : resolved.fillets) {
    boxes.push_back(boxes[fillet.between[0]].merged(boxes[fillet.between[1]]));
  }
  for (const ResolvedJunction& junction : resolved.junctions) {
    boxes.push_back(part_box(junction.shape.hub));
  }
  const Eigen::AlignedBox3d all = bounds_of(std::span(&boxes, 1));
  const double largest = boxes.empty() ? 0 : std::max(all.max().maxCoeff(), -all.min().minCoeff());
  // A box may be all of space, whose size is no number of times zero.
  const double whole = relative > 0 ? margin + relative * std::max(largest, 0.0) : margin;
  for (Eigen::AlignedBox3d& box : boxes) {
    box = {box.min().array() - whole, box.max().array() + whole};
  }
  return boxes;
}

// Of parts that this one refers to.
std::vector<std::string> names_in(const PartKind& kind, const PartShape& shape) {
  std::vector<std::string> names;
  for (References (*list)(const PartShape&) : {kind.references, kind.ends}) {
    for (const Reference& reference : list != nullptr ? list(shape) : References{}) {
      names.push_back(reference.port.part);
    }
  }
  for (const Need& need : kind.needs(shape)) {
    names.push_back(need.part);
  }
  if (kind.pipes != nullptr) {
    const FilletPipes pipes = kind.pipes(shape);
    names.insert(names.end(), pipes.names.begin(), pipes.names.end());
  }
  return names;
}

bool is_disc(const DistrictParts& members, const EndIndex& end) {
  return members.piece && std::ranges::any_of(members.piece->discs, [&](const DiscName& disc) {
           return disc.end == end;
         });
}

// Boxes about parts that share a ring touch there.
void require_whole_runs(const ResolvedAssembly& whole, const DistrictParts& members,
                        const ResolvedAssembly& own) {
  for (std::size_t i = 0; i < own.parts.size(); ++i) {
    for (const End end : {End::start, End::end}) {
      const bool was_joined = whole.parts[members.parts[i]].joined.at(at(end)).has_value();
      if (was_joined && !own.parts[i].joined.at(at(end)) &&
          !is_disc(members, {members.parts[i], end})) {
        throw Error(Errc::internal,
                    "internal error, please report it: a district ends within a run",
                    own.parts[i].name);
      }
    }
  }
}

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

std::vector<std::uint32_t> document_parts(const ResolvedAssembly& resolved,
                                          const DistrictParts& members) {
  std::vector<std::uint32_t> parts;
  for (const auto part : members.parts) {
    parts.push_back(resolved.parts[part].index);
  }
  for (const auto fillet : members.fillets) {
    parts.push_back(resolved.fillets[fillet].index);
  }
  for (const auto junction : members.junctions) {
    parts.push_back(resolved.junctions[junction].index);
  }
  std::ranges::sort(parts);
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  return parts;
}

namespace {

// Of all, those that a name may be about: its own, and of its ends and skins.
void take_patches(const std::map<std::string, std::string>& all, const std::string& name,
                  std::map<std::string, std::string>& result) {
  if (const auto own = all.find(name); own != all.end()) {
    result.insert(*own);
  }
  const std::string dotted = name + ".";
  for (auto next = all.lower_bound(dotted); next != all.end() && next->first.starts_with(dotted);
       ++next) {
    result.insert(*next);
  }
}

}  // namespace

Assembly document_of(const Assembly& assembly, const std::vector<std::uint32_t>& parts) {
  Assembly own;
  own.source = assembly.source;
  own.unit = assembly.unit;
  own.tolerance = assembly.tolerance;
  own.segments = assembly.segments;
  own.wall = assembly.wall;
  own.wall_side = assembly.wall_side;
  own.insulation = assembly.insulation;
  own.is_of_network = assembly.is_of_network;
  for (const std::uint32_t index : parts) {
    own.parts.push_back(assembly.parts[index]);
    if (own.parts.back().pointer.empty()) {
      own.parts.back().pointer = "/parts/" + std::to_string(index);
    }
    take_patches(assembly.patches, own.parts.back().name, own.patches);
  }
  return own;
}

RelatedParts::RelatedParts(const Assembly& assembly) : related_(assembly.parts.size()) {
  std::unordered_map<std::string_view, std::uint32_t> place_of;
  for (std::uint32_t i = 0; i < assembly.parts.size(); ++i) {
    place_of.emplace(assembly.parts[i].name, i);
  }
  for (std::uint32_t i = 0; i < assembly.parts.size(); ++i) {
    const PartShape& shape = assembly.parts[i].shape;
    const PartKind& kind = part_kind(shape);
    for (const std::string& name : names_in(kind, shape)) {
      if (const auto place = place_of.find(name); place != place_of.end()) {
        const auto [from, to] =
            kind.names_end ? std::pair(place->second, i) : std::pair(i, place->second);
        related_[from].push_back(to);
      }
    }
  }
}

District district(const Assembly& assembly, const ResolvedAssembly& resolved,
                  const DistrictParts& members) {
  District result;
  result.parts = document_parts(resolved, members);
  result.assembly = document_of(assembly, result.parts);
  result.resolved = taken(resolved, members);
  for (const ResolvedPart& part : result.resolved.parts) {
    for (const std::string& cap : part.end_names) {
      take_patches(assembly.patches, cap, result.assembly.patches);
    }
  }
  require_whole_runs(resolved, members, result.resolved);
  result.boxes.assign(members.boxes.begin(),
                      members.boxes.begin() + std::ptrdiff_t(members.parts.size()));
  result.piece = members.piece;
  if (result.piece) {
    result.assembly.tolerance = result.piece->tolerance;
    for (auto& [end, name] : result.piece->discs) {
      end.part = members.place_of(end.part);
      result.resolved.parts[end.part].end_names.at(at(end.end)) = name;
    }
  }
  const auto renumber = [&](auto& named) {
    const auto place = std::ranges::lower_bound(result.parts, named.index);
    named.index = std::uint32_t(place - result.parts.begin());
  };
  std::ranges::for_each(result.resolved.parts, renumber);
  std::ranges::for_each(result.resolved.fillets, renumber);
  std::ranges::for_each(result.resolved.junctions, renumber);
  return result;
}

District district_with_loops(const Assembly& assembly, const ResolvedAssembly& resolved,
                             const DistrictParts& members) {
  District result = district(assembly, resolved, members);
  find_loops(result.assembly, result.resolved);
  return result;
}

}  // namespace dupin::assembly
