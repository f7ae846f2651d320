#include "length.h"

#include <string>

#include <gtest/gtest.h>

#include "exit_code.h"

namespace dupin::cli {
namespace {

TEST(Length, is_read_in_the_unit_beside_it) {
  EXPECT_EQ(length_in(Unit::inch, "25.4mm", 7), 1);
  EXPECT_EQ(length_in(Unit::inch, "2", 7), 2) << "without a unit, in that of the document";
  EXPECT_EQ(length_in(Unit::inch, "", 7), 7) << "when not given";
  EXPECT_EQ(mesh_length("1in", 7, "mm"), 25.4);
  EXPECT_EQ(mesh_length("1in", 7, "in"), 1);
  EXPECT_EQ(mesh_length("1cm", 7, ""), 10) << "coordinates without a unit are millimetres";
  EXPECT_EQ(mesh_length("", 7, "no unit"), 7);
}

TEST(Length, that_makes_no_sense_is_a_usage_error) {
  for (const std::string text : {"wide", "-1", "0", "1yd", "nan", "1e999"}) {
    EXPECT_THROW((void)length_in(Unit::metre, text, 0), UsageError) << text;
    EXPECT_THROW((void)mesh_length(text, 0, ""), UsageError) << text;
  }
}

TEST(Length, a_tolerance_without_use_is_refused_and_the_right_option_named) {
  EXPECT_NO_THROW(refuse_tolerance("check", {}));
  CommonOptions common;
  common.tolerance = "1";
  const auto message_of = [&](const std::string& instead) -> std::string {
    try {
      refuse_tolerance("do", common, instead);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message_of(""), "do has no use for --tolerance");
  EXPECT_EQ(message_of("--other"), "do has no use for --tolerance; did you mean --other?");
}

}  // namespace
}  // namespace dupin::cli
