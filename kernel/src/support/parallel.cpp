#include "dupin/kernel/parallel.h"

#include <exception>
#include <vector>

#include <tbb/task_arena.h>

#include "support/blocks.h"

namespace dupin {

void for_each_in_parallel(std::size_t count, const std::function<void(std::size_t)>& visit) {
  std::vector<std::exception_ptr> thrown(count);
  support::for_each_in_parallel(count, [&](std::size_t i) {
    try {
      // What waits for loops of its own does not take up another index meanwhile: it may be in the
      // midst of upward rounding.
      tbb::this_task_arena::isolate([&] { visit(i); });
    } catch (...) {
      thrown[i] = std::current_exception();
    }
  });
  for (const std::exception_ptr& error : thrown) {
    if (error) {
      std::rethrow_exception(error);
    }
  }
}

}  // namespace dupin
