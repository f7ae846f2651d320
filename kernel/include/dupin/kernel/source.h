#pragma once

#include <cstdint>

namespace dupin {

/// Where a triangle of a boolean's result comes from: the operand's position in the call and the
/// triangle's in that operand.
struct Source {
  std::uint32_t operand = 0, triangle = 0;
  friend bool operator==(const Source&, const Source&) = default;
};

}  // namespace dupin
