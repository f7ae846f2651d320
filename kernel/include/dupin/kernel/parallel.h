#pragma once

#include <cstddef>
#include <functional>

namespace dupin {

/// Calls `visit(index)` for all indices below `count`, on as many threads as TBB may use
/// (tbb::global_control), so not in order. What an index throws does not keep the others from being
/// visited; then that of the lowest one is thrown.
void for_each_in_parallel(std::size_t count, const std::function<void(std::size_t)>& visit);

}  // namespace dupin
