#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "dupin/kernel/solid.h"

namespace dupin::test {

/// What a set operation must give; volumes as rationals.
struct ExpectedSolid {
  std::string volume;
  std::size_t components = 1;
  std::int64_t genus = 0;
  std::size_t contacts = 0;
};

/// Operands in a special position.
struct Degeneracy {
  std::string name;
  std::vector<Solid> operands;
  ExpectedSolid united, common, difference;
  std::size_t points, triangles;  ///< of the union
};

/// One of each kind that integer coordinates can show.
[[nodiscard]] std::vector<Degeneracy> degeneracies();

}  // namespace dupin::test
