#include <cmath>
#include <random>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "junction/hub_advice.h"

namespace dupin::junction {
namespace {

std::vector<Ring> random_ends(unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> any;
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Ring> result(3 + seed % 6);
  for (Ring& end : result) {
    const Vec3 direction = Vec3(any(random), any(random), any(random)).normalized();
    const Vec3 off(any(random), any(random), any(random));
    end = {(2 + 18 * share(random)) * direction + (seed % 2) * share(random) * off, -direction,
           0.3 + 1.5 * share(random)};
  }
  return result;
}

// The ends further back by what the text says, times a factor.
std::vector<Ring> as_told(std::vector<Ring> ends, const std::string& text, double times) {
  static const std::regex kMove(R"(end (\d+)(?: along its cone)? by ([0-9.e+-]+\d))");
  for (std::sregex_iterator it(text.begin(), text.end(), kMove), last; it != last; ++it) {
    Ring& end = ends.at(std::stoul((*it)[1]) - 1);
    const double way = times * std::stod((*it)[2]);
    end.center -= way * end.normal;
    end.radius -= way * end.slope;
  }
  return ends;
}

TEST(HubAdvice, ends_that_are_moved_back_as_it_says_do_and_a_little_less_does_not) {
  int moved = 0, in_vain = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    const std::vector<Ring> ends = random_ends(seed);
    const JunctionSearch refused = search_junction(ends);
    if (refused.junction || refused.setbacks.empty()) {
      continue;
    }
    const std::string text = advice(ends, {}, refused);
    if (text.find("it would do to move back") == std::string::npos) {
      EXPECT_THAT(text, testing::HasSubstr("no ends further back")) << seed;
      ++in_vain;
      continue;
    }
    ++moved;
    EXPECT_TRUE(search_junction(as_told(ends, text, 1)).junction) << seed << ": " << text;
    EXPECT_FALSE(search_junction(as_told(ends, text, 0.98)).junction) << seed << ": " << text;
  }
  EXPECT_GT(moved, 10);
  EXPECT_LT(in_vain, moved / 4);
}

// Moved with the radius that it has, an end of a cone would not do.
TEST(HubAdvice, moves_ends_of_cones_along_them) {
  int moved = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::vector<Ring> ends = random_ends(seed);
    for (Ring& end : ends) {
      end.slope = 0.1;
    }
    const JunctionSearch refused = search_junction(ends);
    if (refused.junction || refused.setbacks.empty()) {
      continue;
    }
    const std::string text = advice(ends, {}, refused);
    if (text.find("it would do to move back") != std::string::npos) {
      EXPECT_THAT(text, testing::HasSubstr(" along its cone by "));
      EXPECT_TRUE(search_junction(as_told(ends, text, 1)).junction) << seed << ": " << text;
      ++moved;
    }
  }
  EXPECT_GT(moved, 5);
}

// As of walls that leave no bore in an end, or in an arm, which is thinner than that.
TEST(HubAdvice, moves_no_end_so_far_that_something_else_is_wrong) {
  int moved = 0, in_vain = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::vector<Ring> ends = random_ends(seed);
    for (Ring& end : ends) {
      end.slope = 0.02;
    }
    const JunctionSearch refused = search_junction(ends);
    if (refused.junction || refused.setbacks.empty()) {
      continue;
    }
    const auto takes = [&](std::span<const Ring> tried, const Junction& junction) {
      return junction.hub.radius > 0.2 &&
             std::ranges::all_of(tried, [](const Ring& end) { return end.radius > 0.3; });
    };
    const std::string text = advice(ends, {}, refused, takes);
    if (text.find("move back") == std::string::npos) {
      continue;
    }
    const std::vector<Ring> told = as_told(ends, text, 1);
    const JunctionSearch found = search_junction(told);
    ASSERT_TRUE(found.junction) << seed << ": " << text;
    const bool is_in_vain = text.find("with its walls, no ends further back") != std::string::npos;
    EXPECT_EQ(takes(told, *found.junction), !is_in_vain) << seed << ": " << text;
    ++(is_in_vain ? in_vain : moved);
  }
  EXPECT_GT(moved, 10);
  EXPECT_GT(in_vain, 2);
}

TEST(HubAdvice, says_no_smoothness_where_none_would_do) {
  int found = 0;
  for (unsigned seed = 0; seed < 80; ++seed) {
    const std::vector<Ring> ends = random_ends(seed);
    const JunctionOptions smooth{.smoothness = 0.8};
    const JunctionSearch refused = search_junction(ends, smooth);
    if (!refused.junction && search_junction(ends).junction) {
      const auto never = [](std::span<const Ring>, const Junction&) { return false; };
      EXPECT_EQ(advice(ends, smooth, refused, never), refused.reason) << seed;
      ++found;
    }
  }
  EXPECT_GT(found, 0);
}

TEST(HubAdvice, says_which_smoothness_would_do) {
  static const std::regex kSmoothness(R"(a smoothness of ([0-9.e-]+) would do)");
  int found = 0;
  for (unsigned seed = 0; seed < 80; ++seed) {
    const std::vector<Ring> ends = random_ends(seed);
    const JunctionOptions smooth{.smoothness = 0.8};
    const JunctionSearch refused = search_junction(ends, smooth);
    if (refused.junction || !search_junction(ends).junction) {
      continue;
    }
    const std::string text = advice(ends, smooth, refused);
    std::smatch match;
    ASSERT_TRUE(std::regex_search(text, match, kSmoothness)) << text;
    const double enough = std::stod(match[1]);
    EXPECT_TRUE(search_junction(ends, {.smoothness = enough}).junction) << text;
    EXPECT_LT(enough, 0.8);
    ++found;
  }
  EXPECT_GT(found, 0);
}

// Caps that overlap are not said to be apart, and what nobody chose cannot be made smaller.
TEST(HubAdvice, says_by_how_much_caps_overlap) {
  const std::vector<Ring> ends{
      {{9, 0, 0}, {-1, 0, 0}, 1},
      {{9 * std::cos(0.3), 9 * std::sin(0.3), 0}, {-std::cos(0.3), -std::sin(0.3), 0}, 1}};
  const JunctionOptions wide{.cap_angles = {0.5, 0.5}};
  const JunctionSearch refused = search_junction(ends, wide);
  ASSERT_FALSE(refused.junction);
  EXPECT_THAT(advice(ends, wide, refused), testing::HasSubstr("overlap by"));
  // On a larger hub, they are as wide.
  for (const std::optional<double> radius : {std::optional<double>(), {4.0}, {2.0}, {0.1}}) {
    const JunctionOptions chosen{.radius = radius, .cap_angles = {0.5, 0.5}};
    const std::string text = advice(ends, chosen, search_junction(ends, chosen));
    EXPECT_THAT(text, testing::HasSubstr("smaller caps may do"));
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("larger hub")));
  }
  EXPECT_THAT(advice(ends, wide, refused), testing::Not(testing::HasSubstr("-")));
}

}  // namespace
}  // namespace dupin::junction
