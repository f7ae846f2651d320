#include "dupin/kernel/stage_clock.h"

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/error.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using testing::ElementsAre;

constexpr std::chrono::milliseconds kNap(20);
constexpr double kNapSeconds = 0.02;

std::vector<std::string> stages(const StageClock& clock) {
  std::vector<std::string> names;
  for (const StageTime& time : clock.times()) {
    names.push_back(time.stage);
  }
  return names;
}

TEST(StageClock, sleep_is_time_on_the_wall_and_none_of_processors) {
  StageClock clock;
  clock.begin("sleep");
  std::this_thread::sleep_for(kNap);
  clock.end();
  std::this_thread::sleep_for(2 * kNap);  // nobody's
  const std::vector<StageTime> times = clock.times();
  ASSERT_EQ(times.size(), 1u);
  EXPECT_GE(times[0].wall, kNapSeconds);
  EXPECT_LT(times[0].processor, kNapSeconds);
  EXPECT_EQ(clock.times()[0].wall, times[0].wall);
}

TEST(StageClock, a_stage_that_comes_again_adds_to_its_time) {
  StageClock clock;
  for (int i = 0; i < 2; ++i) {
    clock.begin("first");
    std::this_thread::sleep_for(kNap);
    clock.begin("first");  // goes on
    clock.begin("second");
  }
  EXPECT_THAT(stages(clock), ElementsAre("first", "second"));
  EXPECT_GE(clock.times()[0].wall, 2 * kNapSeconds);
}

TEST(StageClock, the_stage_of_now_lasts_until_now) {
  StageClock clock;
  clock.begin("nap");
  const double before = clock.times()[0].wall;
  std::this_thread::sleep_for(kNap);
  EXPECT_GE(clock.times()[0].wall, before + kNapSeconds);
}

TEST(StageClock, stages_that_are_told_are_begun_unless_the_listener_cancels) {
  StageClock clock;
  tell(clock.progress(), "first");
  EXPECT_THROW(tell(clock.progress([](std::string_view, double) { return false; }), "second"),
               Error);
  EXPECT_THAT(stages(clock), ElementsAre("first", "second"));
  EXPECT_NO_THROW(tell({}, "third"));
}

TEST(StageClock, a_union_tells_its_stages_and_the_listener_may_cancel) {
  const std::vector<Solid> boxes{Solid::from(test::box({0, 0, 0}, {2, 2, 2})),
                                 Solid::from(test::box({1, 1, 1}, {3, 3, 3}))};
  StageClock clock;
  clock.begin("load");
  EXPECT_EQ(unite(boxes, {.progress = clock.progress()}).volume(), 15);
  EXPECT_THAT(stages(clock),
              ElementsAre("load", "search", "intersect", "triangulate", "classify", "extract"));
  const Progress cancel = clock.progress([](std::string_view, double) { return false; });
  EXPECT_THROW((void)unite(boxes, {.progress = cancel}), Error);
}

}  // namespace
}  // namespace dupin
