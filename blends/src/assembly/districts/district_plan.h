#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assembly/selected_parts.h"
#include "dupin/blends/assembly.h"
#include "dupin/blends/resolve.h"
#include "dupin/kernel/districts.h"
#include "dupin/kernel/ring.h"

namespace dupin::assembly {

/// What names of discs begin with: no part is called so, names have no control characters.
constexpr char kSeamMark = '\x1f';

/// The disc, or annulus, that closes an end of a piece where the next one goes on: its label.
struct DiscName {
  EndIndex end;
  std::string name;
};

/// What a piece of something larger takes from that.
struct PieceOf {
  double grid = 0;                      ///< of the lattice
  double tolerance = 0;                 ///< of meshes
  std::vector<RingSampling> samplings;  ///< by part of the piece
  /// Likewise, of bores, or of what is around insulation.
  std::vector<RingSampling> second_samplings;
  std::vector<DiscName> discs;  ///< ends in the whole assembly
};

/// Parts of an assembly that have nothing to do with the others, and boxes about all that is made
/// of them.
struct DistrictParts : PartPlaces {
  Boxes boxes;
  std::optional<PieceOf> piece;  ///< of one that meets others at its discs (divided_districts.h)

  /// Of one of its parts.
  [[nodiscard]] std::uint32_t place_of(std::uint32_t part) const {
    return std::uint32_t(std::ranges::lower_bound(parts, part) - parts.begin());
  }
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
  Boxes boxes;                       ///< about the parts of `resolved`
  std::optional<PieceOf> piece;      ///< whose ends are those of `resolved`
};

/// What its parts, fillets and junctions are made of: places in Assembly::parts, ascending. O(n log
/// n) for n of them.
[[nodiscard]] std::vector<std::uint32_t> document_parts(const ResolvedAssembly& resolved,
                                                        const DistrictParts& members);

/// The document with these of its parts alone, ascending, which keep their places for messages.
[[nodiscard]] Assembly document_of(const Assembly& assembly,
                                   const std::vector<std::uint32_t>& parts);

/// Which parts others refer to, be it to begin at their ends, to join them, or to keep clear of
/// them; and which only name an end of theirs.
class RelatedParts {
 public:
  /// O(n log n).
  explicit RelatedParts(const Assembly& assembly);
  /// By their places in Assembly::parts.
  [[nodiscard]] const std::vector<std::uint32_t>& of(std::uint32_t part) const {
    return related_[part];
  }

 private:
  std::vector<std::vector<std::uint32_t>> related_;
};

/// O(what it has).
[[nodiscard]] District district(const Assembly& assembly, const ResolvedAssembly& resolved,
                                const DistrictParts& members);

/// The same, with the loops of its fillets. Throws as `find_loops` does.
[[nodiscard]] District district_with_loops(const Assembly& assembly,
                                           const ResolvedAssembly& resolved,
                                           const DistrictParts& members);

}  // namespace dupin::assembly
