#include <string>

#include <Eigen/Geometry>

#include "assembly/parts/line_and_arc.h"
#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "assembly/parts/start_ring.h"
#include "assembly/parts/straight_run.h"
#include "dupin/kernel/decimal.h"

namespace dupin::assembly {

template <>
struct PartRules<"pipe"> {
  static References references(const PipeBetween&) { return {}; }
  static References references(const PipeAlong& pipe) { return from_port(pipe.from); }
  static References references(const PipeTo& pipe) { return {{pipe.from, "from"}}; }
  static References references(const PipeOn&) { return {}; }

  static std::vector<Need> needs(const PipeOn& pipe) { return {{pipe.run, "on"}}; }
  static std::vector<Need> needs(const auto&) { return {}; }

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
               (length < 0 ? decimal(-length, kMessageDigits) + " behind it" : "level with it"));
    }
    check_within_tolerance(
        context, aside, "to",
        "the point is " + decimal(aside, kMessageDigits) + " off the pipe's axis");
    return cylinder(start, start.center + length * travel);
  }

  static PartSurface geometry(const PartContext& context, const PipeOn& pipe) {
    const RunAxis run = run_axis(context, pipe.run, "on");
    const Ring start =
        origin(context, Place{point_on_run(context, run, pipe.at), pipe.direction, pipe.radius, {}},
               kSection);
    check_positive(context, pipe.length, "length");
    if (!(start.normal.cross(run.direction).norm() > kNoDirection)) {
      fail(context, "direction", "the direction must lead off the axis of '" + pipe.run + "'");
    }
    return cylinder(start, start.center + pipe.length * opposite(start.normal));
  }
};
template const PartKind& part_kind<"pipe">();

}  // namespace dupin::assembly
