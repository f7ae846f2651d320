#include <utility>

#include "checking/plain_solid.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"

namespace dupin {

Report check(const Rounded& rounded) {
  if (rounded.contacts().empty()) {
    if (auto report = checking::plain_report(rounded.mesh())) {
      return std::move(*report);
    }
  }
  return check(rounded.mesh(), {.self_intersections = false});
}

}  // namespace dupin
