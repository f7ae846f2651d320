#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "support/blocks.h"

namespace dupin::rounding {

/// Per shell, by its first point, the sum of `measure(face, shell)` over its triangles, which
/// `add(Sum)` makes: run by run of triangles of one shell, in their order. `shell_of`: per point
/// the first one of its shell. In parallel, O(n).
template <class Sum, class Measure>
[[nodiscard]] std::map<std::uint32_t, Sum> sums_of_shells(std::span<const Triangle> triangles,
                                                          std::span<const std::uint32_t> shell_of,
                                                          const Measure& measure) {
  using OfShell = std::pair<std::uint32_t, Sum>;
  std::vector<std::vector<OfShell>> parts(support::block_count(triangles.size()));
  support::for_each_block(triangles.size(), [&](const support::Block& block) {
    std::vector<OfShell> runs;
    for (auto face = static_cast<std::uint32_t>(block.begin); face < block.end; ++face) {
      const std::uint32_t shell = shell_of[triangles[face][0]];
      if (runs.empty() || runs.back().first != shell) {
        runs.emplace_back(shell, Sum());
      }
      runs.back().second.add(measure(face, shell));
    }
    parts[block.number] = std::move(runs);
  });
  std::map<std::uint32_t, Sum> sums;
  for (const std::vector<OfShell>& runs : parts) {
    for (const auto& [shell, sum] : runs) {
      sums[shell].add(sum);
    }
  }
  return sums;
}

}  // namespace dupin::rounding
