#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace dupin::tessellation {

/// What a place to step from and to takes of the heights.
struct HeightRange {
  double low, high;
};

/// How long a step from one to another is, at least the difference of their heights; none if
/// something is in between.
using StepLength = std::function<std::optional<double>(std::size_t from, std::size_t to)>;

/// The steps from the first to the second that are the shortest together, by E. W. Dijkstra (1959):
/// where each of them leads to; empty if none lead there. Lengths are asked for only where the
/// difference of heights leaves the step a chance: along a row, of neighbours.
[[nodiscard]] std::vector<std::size_t> shortest_way(const std::vector<HeightRange>& places,
                                                    const StepLength& step);

}  // namespace dupin::tessellation
