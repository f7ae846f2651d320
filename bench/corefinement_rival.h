#pragma once

#include <vector>

#include "dupin/kernel/solid.h"

namespace dupin::bench {

/// The union by CGAL's corefinement, pair by pair, as a measure of comparison.
void unite_by_corefinement(const std::vector<Solid>& operands);

}  // namespace dupin::bench
