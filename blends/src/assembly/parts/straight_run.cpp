#include "assembly/parts/straight_run.h"

#include <algorithm>
#include <limits>

#include "assembly/parts/line_and_arc.h"
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

// The length that a document gives its part is not that of its ends: each of their coordinates, and
// the way between them, is rounded by half an epsilon of its size, and so is what is found here.
Vec3 point_on_run(const PartContext& context, const RunAxis& run, double at) {
  const double rounding =
      4 * std::numeric_limits<double>::epsilon() * (run.from.cwiseAbs().sum() + run.length);
  if (!(at >= 0 && at <= run.length + rounding)) {
    fail(context, "at",
         "must be from 0 to the length of the part it is on, " + decimal_at_least(run.length) +
             ", not " + (at > 0 ? decimal_at_most(at) : decimal(at)));
  }
  return run.from + std::min(at, run.length) * run.direction;
}

}  // namespace dupin::assembly
