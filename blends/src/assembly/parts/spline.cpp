#include <string>
#include <vector>

#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"

namespace dupin::assembly {
namespace {

void check_points(const PartContext& context, const std::vector<Waypoint>& through) {
  for (std::size_t i = 0; i < through.size(); ++i) {
    const std::string key = "through/" + std::to_string(i);
    check_finite(context, through[i].point, key + "/point");
    check_positive(context, through[i].radius, key + "/radius");
  }
}

}  // namespace

template <>
struct PartRules<"spline"> {
  static constexpr bool kIsTangent = true;

  static References references(const SplineBetween& spline) {
    return between_ports(spline.from, spline.to);
  }
  static References references(const SplineRound&) { return {}; }

  static std::string_view portless(const SplineBetween&) { return {}; }
  static std::string_view portless(const SplineRound&) { return "a closed spline"; }

  static PartSurface geometry(const PartContext& context, const SplineBetween& spline) {
    check_points(context, spline.through);
    return Chain(spline_pipe(right_end(context, spline.from, "from"), spline.through,
                             right_end(context, spline.to, "to")));
  }

  static PartSurface geometry(const PartContext& context, const SplineRound& spline) {
    check_points(context, spline.through);
    return Chain(closed_spline_pipe(spline.through), true);
  }
};
template const PartKind& part_kind<"spline">();

}  // namespace dupin::assembly
