#pragma once

#include <map>
#include <string>

#include "dupin/kernel/solid.h"

namespace dupin {

/// The solid with other names for its labels, by their own; labels of one name become one. O(n).
[[nodiscard]] Solid renamed(const Solid& solid, const std::map<std::string, std::string>& names);

}  // namespace dupin
