#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "assembly/districts/district_plan.h"
#include "dupin/blends/build.h"
#include "dupin/blends/resolve.h"

namespace dupin::assembly {

/// A district that is to be divided, of parts of this assembly, and what its pieces take from it.
struct Divisible {
  const ResolvedAssembly& resolved;
  const DistrictParts& members;
  PieceOf common;  ///< for all parts, without discs
};

/// A ring at which a district may be divided: the two parts that share it, by their places in the
/// district, lowest first.
struct SharedRing {
  std::array<std::uint32_t, 2> parts{};
  std::array<EndIndex, 2> ends{};
  std::string name;
};

/// Which rings divide.
struct DividingRule {
  const std::set<std::string>& kept;  ///< names of seams where nothing is to be divided
  /// Of second surfaces, by place in the document (common_rings.h).
  const std::optional<std::vector<double>>& distances;
  std::optional<Region> region;
};

/// What a district falls into where it is divided at all rings that may be: where boxes about the
/// two parts that share one are the only ones that touch of all in both, and where both are as
/// thick, if what is made is hollow.
struct Atoms {
  Boxes boxes;                    ///< about parts, fillets, junctions
  std::vector<SharedRing> rings;  ///< between different atoms, in the order of their parts
  std::vector<std::uint32_t> of;  ///< the atom of each box; numbered by their first ones
  std::size_t count = 0;
};

/// O(n log n) and the boxes that touch.
[[nodiscard]] Atoms atoms_of(const Divisible& whole, const DividingRule& rule);

/// The parts and so on of each group of what is in boxes, numbered by their first ones, with discs
/// at those of the rings that are between two.
[[nodiscard]] std::vector<DistrictParts> pieces_of(const Divisible& whole, const Boxes& boxes,
                                                   std::span<const SharedRing> rings,
                                                   std::span<const std::uint32_t> group_of);

}  // namespace dupin::assembly
