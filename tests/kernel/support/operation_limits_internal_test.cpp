#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/operation_limits.h"

namespace dupin::support {
namespace {

// The message of Error{limit_exceeded}; empty if nothing is thrown.
std::string refusal(const std::function<void()>& operation) {
  try {
    operation();
    return {};
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
    return error.what();
  }
}

TEST(Limits, are_two_to_the_31_points_or_triangles) {
  constexpr std::uint64_t kEnd = std::uint64_t{1} << 31;
  EXPECT_EQ(refusal([] { refuse_too_many(kEnd - 1, kEnd - 1); }), "");
  EXPECT_NE(refusal([] { refuse_too_many(kEnd, 0); }), "");
  EXPECT_NE(refusal([] { refuse_too_many(0, kEnd); }), "");
}

TEST(Limits, of_memory_grow_with_triangles_and_intersections) {
  const auto least_limit = [](std::uint64_t triangles, std::uint64_t intersections) {
    std::uint64_t low = 1, high = std::uint64_t{1} << 40;
    while (low < high) {
      const std::uint64_t middle = (low + high) / 2;
      if (refusal([&] { refuse_too_large(triangles, intersections, middle); }).empty()) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  };
  EXPECT_EQ(least_limit(0, 0), 1U);
  // Not below what boolean_bench reports.
  EXPECT_GE(least_limit(1000, 0), 1000U * 100);
  EXPECT_GE(least_limit(0, 1000), 1000U * 870);
  EXPECT_EQ(least_limit(2000, 3000), 2 * least_limit(1000, 0) + 3 * least_limit(0, 1000));
}

TEST(Limits, of_the_machine_hold_where_none_is_given) {
  EXPECT_EQ(refusal([] { refuse_too_large(1000, 1000, 0); }), "");
  EXPECT_NE(refusal([] { refuse_too_large(std::uint64_t{1} << 50, 0, 0); }), "");
}

TEST(Limits, of_memory_grow_with_pairs_of_boxes) {
  for (const std::uint64_t limit : {1600U, 1000000U, 123456789U}) {
    const std::uint64_t most = most_candidates(limit);
    EXPECT_EQ(refusal([&] { refuse_too_many_candidates(0, most, limit); }), "");
    EXPECT_NE(refusal([&] { refuse_too_many_candidates(0, most + 1, limit); }), "");
    EXPECT_NE(refusal([&] { refuse_too_many_candidates(limit / 100, most, limit); }), "");
  }
  EXPECT_EQ(refusal([] { refuse_too_many_candidates(1000, 1000000, 0); }), "");
  EXPECT_EQ(refusal([] { refuse_too_many_candidates(5, 1000000, 1000000); }),
            "the boolean operation on 5 triangles, of whose boxes 1000000 pairs overlap, would "
            "need about 16.001 MB of memory; allowed are 1 MB");
}

TEST(Limits, are_told_in_numbers) {
  const std::string text = refusal([] { refuse_too_large(5000000, 70, 1000000); });
  EXPECT_NE(text.find("5000000 triangles"), std::string::npos) << text;
  EXPECT_NE(text.find("70 pairs"), std::string::npos) << text;
  EXPECT_NE(text.find("allowed are 1 MB"), std::string::npos) << text;
}

}  // namespace
}  // namespace dupin::support
