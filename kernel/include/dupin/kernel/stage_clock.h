#pragma once

#include <chrono>
#include <ctime>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/kernel/progress.h"

namespace dupin {

/// What a stage of an operation took.
struct StageTime {
  std::string stage;
  double wall = 0;       ///< seconds on the clock
  double processor = 0;  ///< seconds of all the process's threads together
};

/// Says where time goes: one stage at a time, each until the next one begins. Operations tell their
/// stages to `progress()`, so that nothing in them has to be measured.
class StageClock {
 public:
  /// Ends the stage before. One that comes again, as where a union is made in steps, adds to its
  /// time.
  void begin(std::string_view stage);
  /// Until the next one begins, time is nobody's.
  void end();

  /// Begins each stage that an operation tells, and hands on to `listener`, which may be empty.
  /// Valid as long as this object, which stays where it is.
  [[nodiscard]] Progress progress(Progress listener = {});

  /// In the order in which they first began; that of now until now.
  [[nodiscard]] std::vector<StageTime> times() const;

 private:
  /// What the clocks say.
  struct Moment {
    std::chrono::steady_clock::time_point wall = std::chrono::steady_clock::now();
    std::clock_t processor = std::clock();
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::vector<StageTime> times_;
  std::size_t current_ = kNone;
  Moment since_;
};

}  // namespace dupin
