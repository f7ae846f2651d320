#pragma once

#include <random>

#include "dupin/kernel/solid.h"

namespace dupin::test {

/// A box, a frame, a prism or a tube standing along some axis, with corners on the integer points
/// from 0 to 6: two of them share planes, edges and vertices more often than not. The same for the
/// same state of `random` with every standard library.
[[nodiscard]] Solid random_grid_solid(std::mt19937& random);

}  // namespace dupin::test
