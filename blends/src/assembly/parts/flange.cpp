#include "assembly/parts/line_and_arc.h"
#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "assembly/parts/straight_run.h"

namespace dupin::assembly {
namespace {

// From `from` in the unit direction `travel`.
PartSurface disc(const PartContext& context, const Vec3& from, const Vec3& travel, double radius,
                 double thickness) {
  check_positive(context, radius, "radius");
  check_positive(context, thickness, "thickness");
  return cylinder({from, opposite(travel), radius}, from + thickness * travel);
}

}  // namespace

template <>
struct PartRules<"flange"> {
  static constexpr std::array<bool, 2> kClosedEnds{true, true};
  static constexpr bool kIsPad = true;

  static References references(const auto&) { return {}; }

  static std::string_view portless(const auto&) { return "a flange"; }

  static std::vector<Need> needs(const FlangeAt&) { return {}; }
  static std::vector<Need> needs(const FlangeOfEnd& flange) { return {{flange.at.part, "at"}}; }
  static std::vector<Need> needs(const FlangeOn& flange) { return {{flange.run, "on"}}; }

  static PartSurface geometry(const PartContext& context, const FlangeAt& flange) {
    check_finite(context, flange.center, "center");
    check_finite(context, flange.normal, "normal");
    if (!(flange.normal.norm() >= kSmallest)) {
      fail(context, "normal", "the direction must not be zero");
    }
    const Vec3 normal = flange.normal.normalized();
    return disc(context, flange.center - flange.thickness / 2 * normal, normal, flange.radius,
                flange.thickness);
  }

  static PartSurface geometry(const PartContext& context, const FlangeOfEnd& flange) {
    const Ring* ring = port_ring(context.surface(flange.at.part), flange.at.end);
    if (ring == nullptr) {
      fail(context, "at", "'" + flange.at.part + "' has no ends");
    }
    check_positive(context, flange.radius, "radius");
    check_positive(context, flange.thickness, "thickness");
    const bool is_before = context.assembly.parts[context.index].solid;
    const Vec3 across = flange.thickness * ring->normal;
    const Vec3 from = is_before ? ring->center : Vec3(ring->center - across),
               to = is_before ? Vec3(ring->center + across) : ring->center;
    // The end's own centre and normal, bitwise, for discs that are level.
    return Chain(RingedSurface{{from, opposite(ring->normal), flange.radius},
                               {to, ring->normal, flange.radius},
                               LineSpine{from, to},
                               ConstantRadius{flange.radius}});
  }

  static PartSurface geometry(const PartContext& context, const FlangeOn& flange) {
    const RunAxis run = run_axis(context, flange.run, "on");
    const Vec3 middle = point_on_run(context, run, flange.at);
    return disc(context, middle - flange.thickness / 2 * run.direction, run.direction,
                flange.radius, flange.thickness);
  }
};
template const PartKind& part_kind<"flange">();

}  // namespace dupin::assembly
