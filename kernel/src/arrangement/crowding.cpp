#include "arrangement/crowding.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "arrangement/triangle_intersection.h"
#include "mesh/coincident_points.h"
#include "support/blocks.h"
#include "support/hash.h"

namespace dupin::arrangement {
namespace {

// A pair in so many is looked at.
constexpr std::size_t kSampled = 16;

// By its corners, whatever their order, the order of triangles and that of operands. Those that are
// no doubles count nothing: how well they are known may depend on it.
std::uint64_t hash_of(const ArrangementInput& input, std::uint32_t triangle) {
  std::uint64_t hash = 0;
  for (const PointId corner : input.triangles[triangle]) {
    hash += input.points.is_double(corner) ? mesh::hash_of(input.points.coordinates(corner)) : 0;
  }
  return hash;
}

// What those of the candidates have in common that are looked at.
std::vector<TriangleIntersection> sampled_intersections(const ArrangementInput& input,
                                                        std::span<const TrianglePair> candidates) {
  return support::collect_in_order<TriangleIntersection>(
      candidates.size(), [&](std::size_t i, std::vector<TriangleIntersection>& found) {
        const auto& [first, second] = candidates[i];
        if (support::mixed(0, hash_of(input, first) + hash_of(input, second)) % kSampled == 0) {
          const UpwardRounding rounding;
          intersect(input, first, second, found);
        }
      });
}

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

bool crowded(const ArrangementInput& input, std::span<const TrianglePair> candidates,
             std::size_t many) {
  if (input.operands.size() < many + 2) {
    return false;
  }
  const std::vector<TriangleIntersection> intersections = sampled_intersections(input, candidates);
  if (intersections.size() * kSampled < input.triangles.size()) {
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
  return pairs > 0 && common >= many * pairs;
}

}  // namespace dupin::arrangement
