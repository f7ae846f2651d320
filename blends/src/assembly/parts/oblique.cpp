#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "assembly/parts/start_ring.h"

namespace dupin::assembly {

template <>
struct PartRules<"oblique"> {
  static References references(const ObliqueBetween&) { return {}; }
  static References references(const ObliqueTo& part) { return {{part.from, "from"}}; }

  static PartSurface geometry(const PartContext& context, const ObliqueBetween& part) {
    check_finite(context, part.from, "from");
    check_finite(context, part.to, "to");
    check_finite(context, part.normal, "normal");
    check_positive(context, part.start_radius, "radii/0");
    check_positive(context, part.end_radius, "radii/1");
    return oblique_tube(part.from, part.to, part.normal, part.start_radius, part.end_radius);
  }

  static PartSurface geometry(const PartContext& context, const ObliqueTo& part) {
    const Ring start = origin(context, part.from, kSection);
    check_finite(context, part.to, "to");
    check_positive(context, part.end_radius, "end_radius");
    return oblique_tube(start, part.to, part.end_radius);
  }
};
template const PartKind& part_kind<"oblique">();

}  // namespace dupin::assembly
