#include "rounding_options.h"

#include <string>

#include <gtest/gtest.h>

#include "exit_code.h"

namespace dupin::cli {
namespace {

TEST(RoundingOptions, are_those_of_the_library_when_nothing_is_given) {
  const RoundingOptions options = rounding_options({}, "mm");
  EXPECT_EQ(options.tolerance, RoundingOptions().tolerance);
  EXPECT_EQ(options.origin.choice, RoundingOptions().origin.choice);
}

TEST(RoundingOptions, lengths_are_in_the_unit_of_the_mesh) {
  RoundingArguments arguments;
  arguments.tolerance = "1in";
  EXPECT_EQ(rounding_options(arguments, "mm").tolerance, 25.4);
  EXPECT_EQ(rounding_options(arguments, "in").tolerance, 1);
  arguments.tolerance = "wide";
  EXPECT_THROW((void)rounding_options(arguments, "mm"), UsageError);
}

TEST(RoundingOptions, the_origin_is_kept_chosen_or_given) {
  const auto origin_of = [](const std::string& text) {
    RoundingArguments arguments;
    arguments.origin = text;
    return rounding_options(arguments, "").origin;
  };
  EXPECT_EQ(origin_of("keep").choice, Origin::Choice::keep);
  EXPECT_EQ(origin_of("auto").choice, Origin::Choice::automatic);
  EXPECT_EQ(origin_of("1,-2.5,1e3").choice, Origin::Choice::given);
  EXPECT_EQ(origin_of("1,-2.5,1e3").place, Vec3(1, -2.5, 1000));
  for (const std::string text : {"1,2", "1,2,3,", "1;2;3", "1,2,inf", "Auto", " 1,2,3"}) {
    EXPECT_THROW((void)origin_of(text), UsageError) << text;
  }
}

TEST(RoundingOptions, a_grid_is_a_power_of_two) {
  const auto make = [](const std::string& grid) {
    RoundingArguments arguments;
    arguments.grid = grid;
    return rounding_options(arguments, "mm");
  };
  EXPECT_NO_THROW((void)make("0.25mm"));
  EXPECT_NO_THROW((void)make("1024"));
  try {
    (void)make("0.3");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "the grid must be a power of two, such as 0.25, not '0.3'");
  }
}

}  // namespace
}  // namespace dupin::cli
