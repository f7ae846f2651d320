#include "dupin/blends/cyclic_blend.h"

#include "assembly/parts/kept_clear.h"
#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "avoidance/route.h"
#include "dupin/blends/elliptic_tube.h"

namespace dupin::assembly {

template <>
struct PartRules<"cyclic_blend"> {
  static constexpr bool kIsTangent = true;

  static References references(const CyclicBlendBetween& blend) {
    return between_ports(blend.from, blend.to);
  }

  static std::vector<Need> needs(const CyclicBlendBetween& blend) { return needs_of(blend.avoid); }

  static PartSurface geometry(const PartContext& context, const CyclicBlendBetween& blend) {
    check_speeds(context, blend.options.k, blend.options.l);
    const Ring &from = right_end(context, blend.from, "from"),
               &to = right_end(context, blend.to, "to");
    const bool is_elliptic = from.ellipse || to.ellipse;
    Chain chain = is_elliptic ? Chain(elliptic_blend(from, to, blend.options))
                              : Chain(cyclic_blend(from, to, blend.options));
    if (blend.avoid) {
      const auto obstacles = obstacles_of(context, *blend.avoid, {from.center, to.center});
      if (const auto fault = nearness(chain, obstacles, blend.avoid->clearance)) {
        if (is_elliptic) {
          throw *fault;
        }
        return Chain(avoidance::route(from, {}, to, obstacles, blend.avoid->clearance).pipe);
      }
    }
    return chain;
  }

  static PartNotes notes(const CyclicBlendBetween& blend, const PartSurface& surface) {
    return clearance_note(blend.avoid, surface);
  }
};
template const PartKind& part_kind<"cyclic_blend">();

}  // namespace dupin::assembly
