#include "assembly/selected_parts.h"

#include <algorithm>

namespace dupin::assembly {

ResolvedAssembly taken(const ResolvedAssembly& whole, const PartPlaces& places) {
  const auto position = [&](std::uint32_t part) -> std::optional<std::uint32_t> {
    const auto found = std::ranges::lower_bound(places.parts, part);
    const bool is_there = found != places.parts.end() && *found == part;
    return is_there ? std::optional(std::uint32_t(found - places.parts.begin())) : std::nullopt;
  };
  ResolvedAssembly result;
  for (const std::uint32_t place : places.parts) {
    result.parts.push_back(whole.parts[place]);
    for (auto& joined : result.parts.back().joined) {
      const auto next = joined ? position(joined->part) : std::nullopt;
      joined = next ? std::optional(EndIndex{*next, joined->end}) : std::nullopt;
    }
  }
  for (const std::uint32_t place : places.fillets) {
    result.fillets.push_back(whole.fillets[place]);
    for (std::uint32_t& part : result.fillets.back().between) {
      part = position(part).value();
    }
  }
  for (const std::uint32_t place : places.junctions) {
    result.junctions.push_back(whole.junctions[place]);
    for (std::uint32_t& arm : result.junctions.back().arms) {
      arm = position(arm).value();
    }
  }
  return result;
}

SelectedParts selected_parts(const ResolvedAssembly& whole, const std::vector<bool>& is_selected) {
  SelectedParts result;
  PartPlaces places;
  for (std::uint32_t i = 0; i < whole.parts.size(); ++i) {
    const auto next = std::uint32_t(places.parts.size());
    const bool is_taken = is_selected[whole.parts[i].index];
    result.position.push_back(is_taken ? std::optional(next) : std::nullopt);
    if (is_taken) {
      places.parts.push_back(i);
    }
  }
  for (std::uint32_t i = 0; i < whole.fillets.size(); ++i) {
    const auto& [first, second] = whole.fillets[i].between;
    if (result.position[first] && result.position[second]) {
      places.fillets.push_back(i);
    }
  }
  for (std::uint32_t i = 0; i < whole.junctions.size(); ++i) {
    if (is_selected[whole.junctions[i].index]) {
      places.junctions.push_back(i);
    }
  }
  result.resolved = taken(whole, places);
  return result;
}

}  // namespace dupin::assembly
