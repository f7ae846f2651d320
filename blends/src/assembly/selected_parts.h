#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dupin/blends/resolve.h"

namespace dupin::assembly {

/// Places in a resolved assembly, ascending.
struct PartPlaces {
  std::vector<std::uint32_t> parts, fillets, junctions;
};

/// These alone, among which is all that the fillets and junctions need; an end whose neighbour is
/// left out is an end like any other. O(n log n) for n of them.
[[nodiscard]] ResolvedAssembly taken(const ResolvedAssembly& whole, const PartPlaces& places);

/// Some parts of an assembly.
struct SelectedParts {
  ResolvedAssembly resolved;
  /// For each part of the whole assembly, its place in `resolved`; none of one that was left out.
  std::vector<std::optional<std::uint32_t>> position;
};

/// The parts for which `is_selected` says so, one entry for each of Assembly::parts; an end whose
/// neighbour is left out is an end like any other. Fillets stay between two parts that do. O(n).
[[nodiscard]] SelectedParts selected_parts(const ResolvedAssembly& whole,
                                           const std::vector<bool>& is_selected);

}  // namespace dupin::assembly
