#include "certification/part_pairs.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

#include "assembly/part_box.h"

namespace dupin::certification {

namespace {

bool is_joined_to(const CertifiedPart& part, std::uint32_t other) {
  return std::ranges::any_of(part.joined,
                             [&](const auto& end) { return end && end->part == other; });
}

}  // namespace

std::vector<PartPair> all_pairs(std::uint32_t parts) {
  std::vector<PartPair> pairs;
  for (std::uint32_t i = 0; i < parts; ++i) {
    for (std::uint32_t j = i + 1; j < parts; ++j) {
      pairs.push_back({i, j});
    }
  }
  return pairs;
}

std::vector<std::size_t> easiest_first(const std::vector<PartPair>& pairs,
                                       const std::vector<CertifiedPart>& parts) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const CertifiedPart& part : parts) {
    boxes.push_back(assembly::part_box(part.shape));
  }
  std::vector<double> distance;
  for (const auto& [first, second] : pairs) {
    distance.push_back(is_joined_to(parts[first], second)
                           ? std::numeric_limits<double>::infinity()
                           : boxes[first].squaredExteriorDistance(boxes[second]));
  }
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return distance[i]; });
  return order;
}

}  // namespace dupin::certification
