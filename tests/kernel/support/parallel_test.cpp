#include "dupin/kernel/parallel.h"

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dupin {
namespace {

TEST(ForEachInParallel, visits_each_index_once) {
  std::vector<int> visits(1000, 0);
  for_each_in_parallel(visits.size(), [&](std::size_t i) { ++visits[i]; });
  EXPECT_EQ(visits, std::vector<int>(1000, 1));
  for_each_in_parallel(0, [](std::size_t) { FAIL(); });
}

TEST(ForEachInParallel, throws_what_the_lowest_index_does_after_all_others) {
  for (int round = 0; round < 20; ++round) {
    std::atomic<int> visited = 0;
    try {
      for_each_in_parallel(500, [&](std::size_t i) {
        ++visited;
        if (i % 100 == 77) {
          throw std::runtime_error(std::to_string(i));
        }
      });
      ADD_FAILURE() << "nothing thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "77");
      EXPECT_EQ(visited, 500);
    }
  }
}

}  // namespace
}  // namespace dupin
