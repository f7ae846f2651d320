#include <string>
#include <vector>

#include "assembly/parts/kept_clear.h"
#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "avoidance/route.h"

namespace dupin::assembly {
namespace {

void check_points(const PartContext& context, const std::vector<Waypoint>& through) {
  for (std::size_t i = 0; i < through.size(); ++i) {
    const std::string key = "through/" + std::to_string(i);
    check_finite(context, through[i].point, key + "/point");
    check_positive(context, through[i].radius, key + "/radius");
  }
}

std::vector<RingedSurface> avoiding(const PartContext& context, const SplineBetween& spline) {
  const Ring &from = right_end(context, spline.from, "from"),
             &to = right_end(context, spline.to, "to");
  return avoidance::route(from, spline.through, to,
                          obstacles_of(context, *spline.avoid, {from.center, to.center}),
                          spline.avoid->clearance)
      .pipe;
}

}  // namespace

template <>
struct PartRules<"spline"> {
  static constexpr bool kIsTangent = true;

  static References references(const SplineBetween& spline) {
    return between_ports(spline.from, spline.to);
  }
  static References references(const SplineRound&) { return {}; }

  static std::vector<Need> needs(const SplineBetween& spline) { return needs_of(spline.avoid); }
  static std::vector<Need> needs(const SplineRound&) { return {}; }

  static std::string_view portless(const SplineBetween&) { return {}; }
  static std::string_view portless(const SplineRound&) { return "a closed spline"; }

  static PartSurface geometry(const PartContext& context, const SplineBetween& spline) {
    check_points(context, spline.through);
    if (spline.avoid) {
      return Chain(avoiding(context, spline));
    }
    return Chain(spline_pipe(right_end(context, spline.from, "from"), spline.through,
                             right_end(context, spline.to, "to")));
  }

  static PartNotes notes(const SplineBetween& spline, const PartSurface& surface) {
    return clearance_note(spline.avoid, surface);
  }
  static PartNotes notes(const SplineRound& /*spline*/, const PartSurface& /*surface*/) {
    return {};
  }

  static PartSurface geometry(const PartContext& context, const SplineRound& spline) {
    check_points(context, spline.through);
    return Chain(closed_spline_pipe(spline.through), true);
  }
};
template const PartKind& part_kind<"spline">();

}  // namespace dupin::assembly
