#pragma once

#include <tbb/task_group.h>

namespace dupin::support {

/// Tasks of it compute in the arithmetic of the thread that makes it. Others take that of the
/// thread that used TBB first, which may be the program's own.
[[nodiscard]] inline tbb::task_group_context task_context() {
  using Context = tbb::task_group_context;
  return Context(Context::bound, Context::default_traits | Context::fp_settings);
}

}  // namespace dupin::support
