#pragma once

#include <functional>
#include <string_view>

namespace dupin {

/// Called now and then from long operations with the stage's name and the fraction done in [0, 1];
/// return false to cancel (the operation then throws Error{cancelled}). Always called from the
/// thread that started the operation.
using Progress = std::function<bool(std::string_view stage, double fraction)>;

}  // namespace dupin
