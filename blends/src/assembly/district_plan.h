#pragma once

#include <cstdint>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/resolve.h"
#include "dupin/kernel/districts.h"

namespace dupin::assembly {

/// Parts of an assembly that have nothing to do with the others, by their places in the resolved
/// assembly, ascending, and boxes about all that is made of them.
struct DistrictParts {
  std::vector<std::uint32_t> parts, fillets, junctions;
  Boxes boxes;
};

/// In the order of their first parts. Boxes about parts are wider than these by `margin`, and by
/// `relative` of the largest coordinate; a fillet lies in the hull of its pipes' boxes. O(n log n)
/// and the pairs of boxes that touch.
[[nodiscard]] std::vector<DistrictParts> districts_of_parts(const ResolvedAssembly& resolved,
                                                            double margin, double relative = 0);

/// An assembly of these parts alone: as if the document had no others. Parts keep their places in
/// it for messages; caps are left out.
struct District {
  Assembly assembly;
  ResolvedAssembly resolved;
  std::vector<std::uint32_t> parts;  ///< of its parts, the places in Assembly::parts of the whole
};

/// O(what it has).
[[nodiscard]] District district(const Assembly& assembly, const ResolvedAssembly& resolved,
                                const DistrictParts& members);

}  // namespace dupin::assembly
