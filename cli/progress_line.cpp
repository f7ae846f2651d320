#include "progress_line.h"

#include <cmath>
#include <iostream>

#include <unistd.h>

namespace dupin::cli {
namespace {

constexpr std::chrono::milliseconds kInterval(100);
constexpr std::string_view kWipe = "\r\033[K";

}  // namespace

ProgressLine::ProgressLine(bool quiet)
    : enabled_(!quiet && isatty(STDERR_FILENO) == 1), next_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() {
  if (shown_) {
    std::cerr << kWipe << std::flush;
  }
}

Progress ProgressLine::callback() {
  if (!enabled_) {
    return {};
  }
  return [this](std::string_view stage, double fraction) { return show(stage, fraction); };
}

bool ProgressLine::show(std::string_view stage, double fraction) {
  const auto now = std::chrono::steady_clock::now();
  if (now >= next_) {
    next_ = now + kInterval;
    shown_ = true;
    std::cerr << kWipe << stage << ' ' << std::lround(100 * fraction) << " %" << std::flush;
  }
  return true;
}

}  // namespace dupin::cli
