#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "arrangement/input.h"

namespace dupin::arrangement {

/// Three pairs of parallel planes about an operand, along and across its longest edge: long parts
/// that are askew to the axes fill little of their boxes, but nearly all of this.
class OperandSlabs {
 public:
  /// O(triangles). Needs UpwardRounding, as does what it is asked.
  OperandSlabs(const ArrangementInput& input, std::size_t operand);

  /// May be wrong only by saying yes.
  [[nodiscard]] bool may_contain(const IntervalPoint& point) const;

 private:
  std::array<Vec3, 3> directions_;
  std::array<std::pair<double, double>, 3> ranges_;
};

}  // namespace dupin::arrangement
