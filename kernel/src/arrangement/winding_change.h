#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "arrangement/input.h"

namespace dupin::arrangement {

/// By how much the count of each group grows from the front of coincident triangles to their back.
[[nodiscard]] inline std::vector<int> winding_change(const ArrangementInput& input,
                                                     const BooleanRule& rule,
                                                     std::span<const SignedTriangle> cover) {
  std::vector<int> change(rule.groups, 0);
  for (const SignedTriangle& t : cover) {
    change[rule.group_of_operand[input.operand_of(t.triangle)]] += t.sign;
  }
  return change;
}

[[nodiscard]] inline bool changes_nothing(std::span<const int> change) {
  return std::all_of(change.begin(), change.end(), [](int c) { return c == 0; });
}

}  // namespace dupin::arrangement
