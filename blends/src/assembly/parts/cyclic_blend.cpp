#include "dupin/blends/cyclic_blend.h"

#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "dupin/blends/elliptic_tube.h"

namespace dupin::assembly {

template <>
struct PartRules<"cyclic_blend"> {
  static constexpr bool kIsTangent = true;

  static References references(const CyclicBlendBetween& blend) {
    return between_ports(blend.from, blend.to);
  }

  static PartSurface geometry(const PartContext& context, const CyclicBlendBetween& blend) {
    check_speeds(context, blend.options.k, blend.options.l);
    const Ring &from = right_end(context, blend.from, "from"),
               &to = right_end(context, blend.to, "to");
    if (from.ellipse || to.ellipse) {
      return elliptic_blend(from, to, blend.options);
    }
    return cyclic_blend(from, to, blend.options);
  }
};
template const PartKind& part_kind<"cyclic_blend">();

}  // namespace dupin::assembly
