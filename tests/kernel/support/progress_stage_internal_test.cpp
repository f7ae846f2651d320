#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/progress_stage.h"

namespace dupin::support {
namespace {

TEST(ProgressStage, tells_fractions_between_its_ends) {
  std::vector<std::pair<std::string, double>> told;
  const Progress progress = [&](std::string_view name, double fraction) {
    told.emplace_back(name, fraction);
    return true;
  };
  const ProgressStage stage(progress, "sew", 0.5, 0.75);
  for (int i = 0; i < 4; ++i) {
    stage.step(4);
  }
  const std::vector<std::pair<std::string, double>> expected{
      {"sew", 0.5}, {"sew", 0.5625}, {"sew", 0.625}, {"sew", 0.6875}, {"sew", 0.75}};
  EXPECT_EQ(told, expected);
}

TEST(ProgressStage, ends_the_operation_when_told_to) {
  const Progress no = [](std::string_view, double fraction) { return fraction < 0.5; };
  EXPECT_THROW(ProgressStage(no, "sew", 0.5, 1), Error);
  const ProgressStage stage(no, "sew", 0, 1);
  stage.step(3);
  try {
    stage.step(3);
    FAIL() << "it goes on";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::cancelled);
  }
}

TEST(ProgressStage, counts_steps_of_other_threads_and_tells_none_there) {
  int calls = 0;
  double last = 0;
  const Progress progress = [&](std::string_view, double fraction) {
    ++calls;
    last = fraction;
    return true;
  };
  const ProgressStage stage(progress, "sew", 0, 1);
  std::thread([&] {
    stage.step(4);
    stage.step(4);
  }).join();
  EXPECT_EQ(calls, 1);
  stage.step(4);
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(last, 0.75);
}

}  // namespace
}  // namespace dupin::support
