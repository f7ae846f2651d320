#include <string>
#include <utility>

#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "dupin/blends/elliptic_tube.h"
#include "dupin/blends/spine.h"

namespace dupin::assembly {

template <>
struct PartRules<"two_cone_blend"> {
  static constexpr bool kIsTangent = true;

  static References references(const TwoConeBlendBetween& blend) {
    return between_ports(blend.from, blend.to);
  }

  static PartSurface geometry(const PartContext& context, const TwoConeBlendBetween& blend) {
    const Ring &from = right_end(context, blend.from, "from"),
               &to = right_end(context, blend.to, "to");
    check_positive(context, blend.reach[0], "reach/0");
    check_positive(context, blend.reach[1], "reach/1");
    for (std::size_t i = 0; i < 3; ++i) {
      check_positive(context, blend.m.at(i), "m/" + std::to_string(i));
      check_positive(context, blend.w.at(i), "w/" + std::to_string(i));
    }
    for (const auto& [ring, key] : {std::pair(&from, "from"), std::pair(&to, "to")}) {
      if (ring->slope != 0 || across_slope(*ring) != 0) {
        fail(context, key,
             "a blend on the spine of two cones goes on from cylinders only, not from a cone");
      }
    }
    const Spine spine = two_cone_spine({from.center, from.center + blend.reach[0] * from.normal,
                                        to.center + blend.reach[1] * to.normal, to.center},
                                       blend.m, blend.w);
    const Ring start = flipped(from), end = flipped(to);
    if (from.ellipse || to.ellipse) {
      return elliptic_tube(start, end, spine, CubicRadius{from.radius, to.radius},
                           CubicRadius{across(from), across(to)});
    }
    return RingedSurface{start, end, spine, CubicRadius{from.radius, to.radius}};
  }
};
template const PartKind& part_kind<"two_cone_blend">();

}  // namespace dupin::assembly
