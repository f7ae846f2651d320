#include <utility>

#include "checking/plain_solid.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/rounding.h"
#include "exact/float_lattice.h"
#include "rounding/rounding_options.h"

namespace dupin {

void require_something_left(const RoundingReport& report, std::size_t triangles,
                            const RoundingOptions& options) {
  if (triangles > 0 || report.removed_shells == 0) {
    return;
  }
  const auto& whole = options.whole;
  const double largest = rounding::largest_of(options, report.origin);
  const double size = whole ? whole->box.sizes().maxCoeff() : largest;
  throw rounding::unroundable_error(
      {.at = report.thin_shells.empty() ? report.origin : report.thin_shells.front().place,
       .coordinates = report.coordinates,
       .is_far = size<largest, .is_on_output_grid = options.output_grid> 0,
       .is_nothing = true,
       .do_doubles_tell = size > exact::FloatLattice(Coordinates::binary64).step(largest)});
}

Report check(const Rounded& rounded) {
  const UsualArithmetic usual;
  if (rounded.contacts().empty()) {
    if (auto report = checking::plain_report(rounded.mesh())) {
      return std::move(*report);
    }
  }
  return check(rounded.mesh(), {.self_intersections = false});
}

}  // namespace dupin
