#include "assembly/selected_parts.h"

#include <algorithm>

namespace dupin::assembly {

SelectedParts selected_parts(const ResolvedAssembly& whole, const std::vector<bool>& is_selected) {
  SelectedParts result;
  for (const ResolvedPart& part : whole.parts) {
    const auto next = std::uint32_t(result.resolved.parts.size());
    result.position.push_back(is_selected[part.index] ? std::optional(next) : std::nullopt);
    if (is_selected[part.index]) {
      result.resolved.parts.push_back(part);
    }
  }
  for (ResolvedPart& part : result.resolved.parts) {
    for (auto& joined : part.joined) {
      const auto position = joined ? result.position[joined->part] : std::nullopt;
      joined = position ? std::optional(EndIndex{*position, joined->end}) : std::nullopt;
    }
  }
  for (ResolvedFillet fillet : whole.fillets) {
    const auto first = result.position[fillet.between[0]],
               second = result.position[fillet.between[1]];
    if (first && second) {
      fillet.between = {*first, *second};
      result.resolved.fillets.push_back(std::move(fillet));
    }
  }
  for (ResolvedJunction junction : whole.junctions) {
    if (is_selected[junction.index]) {
      std::ranges::for_each(junction.arms, [&](auto& arm) { arm = *result.position[arm]; });
      result.resolved.junctions.push_back(std::move(junction));
    }
  }
  return result;
}

}  // namespace dupin::assembly
