#include "assembly/parts/line_and_arc.h"
#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "assembly/parts/start_ring.h"

namespace dupin::assembly {
namespace {

constexpr SectionKeys kConeSection{"radii/0", "semi_axes/0/0", "semi_axes/0/1"};

EndSection end_section(const PartContext& context, const Ring& start, double radius,
                       const std::optional<double>& across, const std::optional<Vec3>& axis,
                       bool own_start) {
  check_positive(context, radius,
                 across ? (own_start ? "semi_axes/1/0" : "end_semi_axes/0")
                        : (own_start ? "radii/1" : "end_radius"));
  if (!across) {
    return {radius, std::nullopt};
  }
  check_positive(context, *across, own_start ? "semi_axes/1/1" : "end_semi_axes/1");
  if (start.ellipse && axis) {
    fail(context, "axis", "the cone begins in an ellipse, whose axis it keeps");
  }
  if (!start.ellipse && !axis) {
    fail(context, "end_semi_axes",
         "the cone begins in a circle; say by an 'axis' which way the ellipse "
         "that it ends in lies");
  }
  return {radius,
          Ellipse{start.ellipse ? start.ellipse->axis : axis_across(context, start.normal, *axis),
                  *across}};
}

}  // namespace

template <>
struct PartRules<"cone"> {
  static References references(const ConeBetween&) { return {}; }
  static References references(const ConeAlong& cone) { return from_port(cone.from); }

  static PartSurface geometry(const PartContext& context, const ConeBetween& cone) {
    const Ring start = start_between(context, cone.from, cone.to, cone.start_radius,
                                     cone.start_axes, kConeSection);
    const EndSection end = end_section(context, start, cone.end_radius, cone.end_across, {}, true);
    return line(start, cone.to, end, true);
  }

  static PartSurface geometry(const PartContext& context, const ConeAlong& cone) {
    const Ring start = origin(context, cone.from, kConeSection);
    check_positive(context, cone.length, "length");
    const bool own_start = std::holds_alternative<Place>(cone.from);
    const EndSection end =
        end_section(context, start, cone.end_radius, cone.end_across, cone.axis, own_start);
    return line(start, start.center + cone.length * opposite(start.normal), end, own_start);
  }
};
template const PartKind& part_kind<"cone">();

}  // namespace dupin::assembly
