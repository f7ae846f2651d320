#include "arrangement/crowding.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace dupin::arrangement {
namespace {

// Operands that each operand meets, ascending. Intersections come pair by pair of operands.
std::vector<std::vector<std::uint32_t>> met_by_each(
    const ArrangementInput& input, std::span<const TriangleIntersection> intersections) {
  std::vector<std::vector<std::uint32_t>> met(input.operands.size());
  std::uint32_t a = 0, b = 0;
  const auto belongs = [&input](std::uint32_t t, std::uint32_t operand) {
    return t >= input.first_triangle[operand] && t < input.first_triangle[operand + 1];
  };
  for (const TriangleIntersection& e : intersections) {
    if (a != b && belongs(e.first, a) && belongs(e.second, b)) {
      continue;
    }
    a = input.operand_of(e.first);
    b = input.operand_of(e.second);
    if (a != b) {
      met[a].push_back(b);
      met[b].push_back(a);
    }
  }
  for (std::vector<std::uint32_t>& operands : met) {
    std::sort(operands.begin(), operands.end());
    operands.erase(std::unique(operands.begin(), operands.end()), operands.end());
  }
  return met;
}

}  // namespace

bool crowded(const ArrangementInput& input, std::span<const TriangleIntersection> intersections) {
  // Fewer in common are arranged at once as fast, and so are operands that hardly touch.
  constexpr std::size_t kManyInCommon = 8;
  if (input.operands.size() < kManyInCommon + 2 || intersections.size() < input.triangles.size()) {
    return false;
  }
  const std::vector<std::vector<std::uint32_t>> met = met_by_each(input, intersections);
  std::size_t pairs = 0, common = 0;
  std::vector<std::uint8_t> is_met(met.size(), 0);
  for (const std::vector<std::uint32_t>& mine : met) {
    for (const std::uint32_t operand : mine) {
      is_met[operand] = 1;
    }
    for (const std::uint32_t operand : mine) {
      ++pairs;
      for (const std::uint32_t other : met[operand]) {
        common += is_met[other];
      }
    }
    for (const std::uint32_t operand : mine) {
      is_met[operand] = 0;
    }
  }
  return pairs > 0 && common >= kManyInCommon * pairs;
}

}  // namespace dupin::arrangement
