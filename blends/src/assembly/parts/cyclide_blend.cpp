#include "dupin/blends/cyclide_blend.h"

#include <string>
#include <utility>

#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "dupin/blends/cyclic_blend.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {

template <>
struct PartRules<"cyclide_blend"> {
  static constexpr bool is_blend = true;

  static References references(const CyclideBlendBetween& blend) {
    return between_ports(blend.from, blend.to);
  }

  static PartSurface geometry(const PartContext& context, const CyclideBlendBetween& blend) {
    const Ring &from = right_end(context, blend.from, "from"),
               &to = right_end(context, blend.to, "to");
    CyclideSearch search = search_cyclide_blend(from, to);
    if (search.tube) {
      return std::move(*search.tube);
    }
    try {
      return cyclic_blend(from, to);
    } catch (const Error& error) {
      if (error.code() != Errc::infeasible_blend) {
        throw;
      }
      std::string reasons;
      for (const std::string& reason : search.rejected) {
        reasons += reason + "; ";
      }
      throw Error(error.code(),
                  "no blend joins these ends. " + reasons + "ringed: " + error.message());
    }
  }

  static PartNotes notes(const CyclideBlendBetween&, const PartSurface& surface) {
    const auto* tube = std::get_if<CyclideTube>(&surface);
    return {tube == nullptr ? "ringed" : std::string(kind(*tube)),
            search_cyclide_blend(flipped(*port_ring(surface, PartEnd::start)),
                                 flipped(*port_ring(surface, PartEnd::end)))
                .rejected,
            {}};
  }
};
template const PartKind& part_kind<"cyclide_blend">();

}  // namespace dupin::assembly
