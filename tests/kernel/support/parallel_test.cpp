#include "dupin/kernel/parallel.h"

#include <atomic>
#include <cfenv>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

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

// Whatever arithmetic a program first used TBB in.
TEST(ForEachInParallel, computes_as_its_caller_does) {
  for (const int mode : {FE_UPWARD, FE_TONEAREST, FE_DOWNWARD, FE_TONEAREST}) {
    std::fesetround(mode);
    std::vector<int> modes(1000, -1);
    for_each_in_parallel(modes.size(), [&](std::size_t i) { modes[i] = std::fegetround(); });
    const int after = std::fegetround();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(modes, std::vector<int>(1000, mode));
    EXPECT_EQ(after, mode);
  }
}

TEST(ForEachInOrder, takes_in_order_one_at_a_time_what_is_made) {
  for (int round = 0; round < 20; ++round) {
    std::vector<std::atomic<int>> made(300);
    std::vector<std::size_t> taken;
    for_each_in_order(
        made.size(), [&](std::size_t i) { ++made[i]; },
        [&](std::size_t i) {
          EXPECT_EQ(made[i], 1);
          taken.push_back(i);
        });
    std::vector<std::size_t> all(made.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(taken, all);
  }
  const auto never = [](std::size_t) { FAIL(); };
  for_each_in_order(0, never, never);
}

TEST(ForEachInOrder, takes_before_all_is_made) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  std::string steps;
  for_each_in_order(
      3, [&](std::size_t i) { steps += "m" + std::to_string(i); },
      [&](std::size_t i) { steps += "t" + std::to_string(i); });
  EXPECT_EQ(steps, "m0t0m1t1m2t2");
}

TEST(ForEachInOrder, throws_what_the_lowest_index_does_and_takes_none_behind_it) {
  for (int round = 0; round < 20; ++round) {
    for (const bool is_made : {false, true}) {
      std::vector<std::size_t> taken;
      const auto fail = [](std::size_t i) {
        if (i % 100 == 77) {
          throw std::runtime_error(std::to_string(i));
        }
      };
      const auto make = [&](std::size_t i) {
        if (!is_made || i > 77) {
          fail(i);
        }
      };
      try {
        for_each_in_order(500, make, [&](std::size_t i) {
          fail(i);
          taken.push_back(i);
        });
        ADD_FAILURE() << "nothing thrown";
      } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "77");
        EXPECT_EQ(taken.size(), 77);
      }
    }
  }
}

TEST(ForEachInOrder, begins_none_behind_one_that_has_thrown) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  int made = 0;
  EXPECT_THROW(for_each_in_order(
                   500, [&](std::size_t) { ++made; },
                   [](std::size_t i) {
                     if (i == 7) {
                       throw std::runtime_error("");
                     }
                   }),
               std::runtime_error);
  EXPECT_EQ(made, 8);
}

double tenth(double one) {
  const volatile double now = one;  // not when this is compiled
  return now / 10;
}

TEST(UsualArithmetic, rounds_to_nearest_while_it_lives_whatever_the_caller_does) {
  const double nearest = tenth(1);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST}) {
    std::fesetround(mode);
    const double callers = tenth(-1);
    {
      const UsualArithmetic usual;
      EXPECT_EQ(std::fegetround(), FE_TONEAREST);
      EXPECT_EQ(tenth(1), nearest);
      const UsualArithmetic within;
    }
    EXPECT_EQ(std::fegetround(), mode);
    EXPECT_EQ(tenth(-1), callers);
  }
  std::fesetround(FE_TONEAREST);
}

#ifdef __SSE2__
TEST(UsualArithmetic, has_denormal_numbers_where_the_caller_has_none) {
  const unsigned before = _mm_getcsr(), flushing = before | 0x8040U;
  _mm_setcsr(flushing);
  volatile double least = 0x1p-1022;
  double half = 0;
  {
    const UsualArithmetic usual;
    half = least / 2;
  }
  EXPECT_EQ(_mm_getcsr() & 0x8040U, 0x8040U);
  _mm_setcsr(before);
  EXPECT_EQ(half, 0x1p-1023);
}
#endif

}  // namespace
}  // namespace dupin
