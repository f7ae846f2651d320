#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "dupin/kernel/error.h"

namespace dupin {

/// Called now and then from long operations with the stage's name and the fraction done in [0, 1];
/// return false to cancel (the operation then throws Error{cancelled}). Always called from the
/// thread that started the operation.
using Progress = std::function<bool(std::string_view stage, double fraction)>;

/// Tells, if there is anyone to be told, that a stage begins, or how much of it is done. Throws
/// Error{cancelled}.
inline void tell(const Progress& progress, std::string_view stage, double fraction = 0) {
  if (progress && !progress(stage, fraction)) {
    throw Error(Errc::cancelled, "cancelled at the stage '" + std::string(stage) + "'");
  }
}

}  // namespace dupin
