#include "dupin/kernel/stage_clock.h"

#include <algorithm>
#include <utility>

namespace dupin {

void StageClock::begin(std::string_view stage) {
  if (current_ != kNone && times_[current_].stage == stage) {
    return;
  }
  end();
  const auto at = std::ranges::find(times_, stage, &StageTime::stage);
  current_ = static_cast<std::size_t>(at - times_.begin());
  if (at == times_.end()) {
    times_.push_back({std::string(stage)});
  }
}

void StageClock::end() {
  times_ = times();
  current_ = kNone;
  since_ = {};
}

Progress StageClock::progress(Progress listener) {
  return [this, listener = std::move(listener)](std::string_view stage, double fraction) {
    begin(stage);
    return !listener || listener(stage, fraction);
  };
}

std::vector<StageTime> StageClock::times() const {
  std::vector<StageTime> times = times_;
  if (current_ != kNone) {
    const Moment now;
    times[current_].wall += std::chrono::duration<double>(now.wall - since_.wall).count();
    times[current_].processor +=
        static_cast<double>(now.processor - since_.processor) / CLOCKS_PER_SEC;
  }
  return times;
}

}  // namespace dupin
