#pragma once

#include <chrono>
#include <memory>

#include "dupin/kernel/progress.h"

namespace dupin::cli {

/// Shows the stage and its percentage on one line of standard error, rewritten in place and wiped
/// at the end of its life. Silent when standard error is no terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// To be handed to an operation; valid as long as this object.
  [[nodiscard]] Progress callback();

 private:
  bool show(std::string_view stage, double fraction);

  bool enabled_ = false;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace dupin::cli
