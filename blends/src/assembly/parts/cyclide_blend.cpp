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
  static constexpr bool kIsTangent = true;

  static References references(const CyclideBlendBetween& blend) {
    return between_ports(blend.from, blend.to);
  }

  static PartSurface geometry(const PartContext& context, const CyclideBlendBetween& blend) {
    const Ring &from = right_end(context, blend.from, "from"),
               &to = right_end(context, blend.to, "to");
    CyclideSearch search = search_cyclide_blend(from, to);
    if (search.tube) {
      return *search.tube;
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
    const Chain& chain = std::get<Chain>(surface);
    return {cyclide_pieces(chain).empty() ? "ringed" : std::string(kind(chain)),
            search_cyclide_blend(flipped(*port_ring(surface, End::start)),
                                 flipped(*port_ring(surface, End::end)))
                .rejected,
            {}};
  }
};
template const PartKind& part_kind<"cyclide_blend">();

}  // namespace dupin::assembly
