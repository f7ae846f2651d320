#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "assembly/districts/district_plan.h"
#include "dupin/blends/assembly.h"
#include "dupin/blends/build.h"
#include "dupin/blends/resolve.h"
#include "dupin/kernel/districts.h"

namespace dupin::assembly {

/// How a district is divided.
struct Division {
  double most = 0;       ///< triangles that are expected of a piece, if it can be divided so far
  double undivided = 0;  ///< districts of which no more are expected are left whole
  std::set<std::string> kept;         ///< names of seams where nothing is to be divided
  std::optional<Region> region = {};  ///< that is to be made
};

/// Districts, some of which are pieces of what hangs together.
struct DividedDistricts {
  std::vector<DistrictParts> districts;  ///< in the order of their first parts
  std::vector<Seam> seams;
  /// Where pipes were cut, to divide what rings do not: what the districts have parts of.
  std::optional<ResolvedAssembly> cut = {};
};

/// So many parts hang together at least in what is divided.
constexpr std::size_t kLeastParts = 32;

/// Districts of which more triangles are expected are divided at rings that two
/// parts of a run share, wherever boxes about these two are the only ones that touch of all in both
/// pieces, and where both are as thick, if what is made is hollow. What cannot be divided so far
/// stays larger, if pipes cannot be cut, where nothing else is near: then these become stretches
/// that share a ring. All that pieces have in common with their whole, its tolerance, lattice and
/// samplings, they take from it; so what they come out as depends on nothing else. O(n log n) and
/// the boxes that touch.
[[nodiscard]] DividedDistricts divided(const Assembly& assembly, const ResolvedAssembly& resolved,
                                       std::vector<DistrictParts> districts,
                                       const Division& division);

/// How many triangles the parts' surfaces have, and how many more where they cross; roughly. Needs
/// the loops of fillets.
struct ExpectedTriangles {
  double surface = 0, crossings = 0;
};
[[nodiscard]] ExpectedTriangles expected_of(const District& district);
/// All of a region of it; of its surfaces alone, if these are expected to have more than enough.
[[nodiscard]] double expected_triangles(const District& district, std::optional<Region> region,
                                        double enough = std::numeric_limits<double>::infinity());

}  // namespace dupin::assembly
