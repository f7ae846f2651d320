#include "dupin/kernel/parallel.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <vector>

#include <tbb/task_arena.h>

#include "support/blocks.h"

namespace dupin {
namespace {

using Step = std::function<void(std::size_t)>;

/// What waits for loops of its own does not take up another index meanwhile: it may be in the midst
/// of upward rounding.
void isolated(const Step& step, std::size_t index) {
  tbb::this_task_arena::isolate([&] { step(index); });
}

class InOrder {
 public:
  InOrder(std::size_t count, const Step& make, const Step& take)
      : made_(count), make_(make), take_(take), failed_(count) {}

  void make_next() {
    const std::size_t index = begun_++;
    if (index < failed_ && is_done(make_, index)) {
      made_[index] = true;
    }
    // Who takes meanwhile, or the next one who has made something, takes this, too.
    if (const std::unique_lock taking(taking_, std::try_to_lock); taking) {
      take_made();
    }
  }

  void finish() {
    take_made();
    if (error_) {
      std::rethrow_exception(error_);
    }
  }

 private:
  void take_made() {
    while (taken_ < failed_ && made_[taken_] && is_done(take_, taken_)) {
      ++taken_;
    }
  }

  [[nodiscard]] bool is_done(const Step& step, std::size_t index) {
    try {
      isolated(step, index);
      return true;
    } catch (...) {
      const std::lock_guard lock(failing_);
      if (index < failed_) {
        failed_ = index;
        error_ = std::current_exception();
      }
      return false;
    }
  }

  std::vector<std::atomic<bool>> made_;
  const Step& make_;
  const Step& take_;
  std::atomic<std::size_t> begun_{0};
  std::atomic<std::size_t> failed_;  // the lowest index that has thrown; those before it are begun
  std::size_t taken_ = 0;
  std::mutex taking_, failing_;
  std::exception_ptr error_;
};

}  // namespace

void for_each_in_parallel(std::size_t count, const std::function<void(std::size_t)>& visit) {
  std::vector<std::exception_ptr> thrown(count);
  support::for_each_in_parallel(count, [&](std::size_t i) {
    try {
      isolated(visit, i);
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

void for_each_in_order(std::size_t count, const std::function<void(std::size_t)>& make,
                       const std::function<void(std::size_t)>& take) {
  InOrder steps(count, make, take);
  support::for_each_in_parallel(count, [&](std::size_t) { steps.make_next(); });
  steps.finish();
}

}  // namespace dupin
