#include "assembly/parts/straight_run.h"

#include "assembly/line_and_arc.h"
#include "assembly/parts/part_checks.h"
#include "dupin/kernel/decimal.h"

namespace dupin::assembly {
namespace {

bool is_straight(const PartSurface& surface) {
  const auto* chain = std::get_if<Chain>(&surface);
  return chain != nullptr && chain->pieces.size() == 1 &&
         std::visit(
             [](const auto& piece) {
               if constexpr (requires { piece.spine; }) {
                 return std::holds_alternative<LineSpine>(piece.spine);
               }
               return false;
             },
             chain->pieces.front());
}

}  // namespace

RunAxis run_axis(const PartContext& context, const std::string& name, std::string_view key) {
  const PartSurface& surface = context.surface(name);
  if (!is_straight(surface)) {
    fail(context, key, "'" + name + "' is no straight pipe or cone");
  }
  const Ring &start = *port_ring(surface, End::start), &end = *port_ring(surface, End::end);
  return {start.center, opposite(start.normal), (end.center - start.center).norm()};
}

Vec3 point_on_run(const PartContext& context, const RunAxis& run, double at) {
  if (!(at >= 0 && at <= run.length)) {
    fail(context, "at",
         "must be from 0 to the length of the part it is on, " +
             decimal(run.length, kMessageDigits) + ", not " + decimal(at, kMessageDigits));
  }
  return run.from + at * run.direction;
}

}  // namespace dupin::assembly
