#pragma once

#include <algorithm>
#include <atomic>
#include <string_view>
#include <thread>

#include "dupin/kernel/error.h"
#include "dupin/kernel/progress.h"

namespace dupin::support {

/// A part of the operation, told to the caller's progress callback, which may cancel. Lives on the
/// thread that started the operation; any thread may count steps.
class ProgressStage {
 public:
  /// Steps done move the fraction from `begin` to `end`. Throws Error{cancelled}.
  ProgressStage(const Progress& progress, std::string_view name, double begin, double end)
      : progress_(progress), name_(name), begin_(begin), end_(end) {
    tell(begin);
  }
  ProgressStage(const ProgressStage&) = delete;
  ProgressStage& operator=(const ProgressStage&) = delete;

  /// One of `total` steps is done. Throws Error{cancelled}, on the starting thread only.
  void step(std::size_t total) const {
    if (!progress_) {
      return;
    }
    const std::size_t done = done_.fetch_add(1, std::memory_order_relaxed) + 1;
    if (std::this_thread::get_id() == thread_) {
      const double part = static_cast<double>(done) / static_cast<double>(total);
      tell(std::clamp(begin_ + (end_ - begin_) * part, begin_, end_));
    }
  }

 private:
  void tell(double fraction) const {
    if (progress_ && !progress_(name_, fraction)) {
      throw Error(Errc::cancelled, "the boolean operation was cancelled");
    }
  }

  const Progress& progress_;
  std::string_view name_;
  double begin_, end_;
  std::thread::id thread_ = std::this_thread::get_id();
  mutable std::atomic<std::size_t> done_{0};
};

}  // namespace dupin::support
