#include <string>

#include "assembly/line_and_arc.h"
#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "assembly/parts/start_ring.h"
#include "dupin/kernel/decimal.h"

namespace dupin::assembly {

template <>
struct PartRules<"pipe"> {
  static References references(const PipeBetween&) { return {}; }
  static References references(const PipeAlong& pipe) { return from_port(pipe.from); }
  static References references(const PipeTo& pipe) { return {{pipe.from, "from"}}; }

  static PartSurface geometry(const PartContext& context, const PipeBetween& pipe) {
    return cylinder(start_between(context, pipe.from, pipe.to, pipe.radius, pipe.axes, kSection),
                    pipe.to);
  }

  static PartSurface geometry(const PartContext& context, const PipeAlong& pipe) {
    const Ring start = origin(context, pipe.from, kSection);
    check_positive(context, pipe.length, "length");
    return cylinder(start, start.center + pipe.length * opposite(start.normal));
  }

  static PartSurface geometry(const PartContext& context, const PipeTo& pipe) {
    const Ring start = origin(context, pipe.from, kSection);
    check_finite(context, pipe.to, "to");
    const Vec3 travel = opposite(start.normal), chord = pipe.to - start.center;
    const double length = chord.dot(travel), aside = (chord - length * travel).norm();
    if (!(length > 0)) {
      fail(context, "to",
           "the point must lie ahead of '" + to_string(pipe.from) + "', not " +
               decimal(-length, kMessageDigits) + " behind it");
    }
    check_within_tolerance(
        context, aside, "to",
        "the point is " + decimal(aside, kMessageDigits) + " off the pipe's axis");
    return cylinder(start, start.center + length * travel);
  }
};
template const PartKind& part_kind<"pipe">();

}  // namespace dupin::assembly
