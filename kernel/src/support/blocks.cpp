#include "support/blocks.h"

#include <tbb/parallel_for.h>

#include "support/task_context.h"

namespace dupin::support {

void for_each_in_parallel(std::size_t count, const std::function<void(std::size_t)>& visit) {
  tbb::task_group_context context = task_context();
  tbb::parallel_for(std::size_t{0}, count, visit, context);
}

}  // namespace dupin::support
