#pragma once

#include <string>

#include "assembly/bore.h"
#include "dupin/kernel/error.h"

namespace dupin::network {

/// A build that keeps going does without one part after the other, so often at most.
constexpr int kMostRounds = 50;

/// Whether doing without the part that an error names, or replacing it, may help.
[[nodiscard]] inline bool is_of_part(Errc code) {
  return code == Errc::irregular_surface || code == Errc::infeasible_blend ||
         code == Errc::self_intersecting || code == Errc::invalid_argument;
}

/// The part that an error names, be it its bore that is at fault.
[[nodiscard]] inline std::string named_part(const Error& error) {
  std::string name = error.part();
  if (name.ends_with(assembly::kBoreSuffix)) {
    name.resize(name.size() - assembly::kBoreSuffix.size());
  }
  return name;
}

}  // namespace dupin::network
