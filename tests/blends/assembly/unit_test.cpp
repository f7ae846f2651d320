#include "dupin/blends/unit.h"

#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/message_of.h"

namespace dupin {
namespace {

TEST(Unit, reads_lengths_as_people_type_them) {
  EXPECT_EQ(parse_length("0.05", Unit::inch), 0.05);
  EXPECT_EQ(parse_length("1mm", Unit::millimetre), 1);
  EXPECT_EQ(parse_length("0.5in", Unit::millimetre), 12.7);
  EXPECT_EQ(parse_length("25.4mm", Unit::inch), 1);
  EXPECT_EQ(parse_length("1e-3m", Unit::millimetre), 1);
  EXPECT_EQ(parse_length("2ft", Unit::inch), 24);
  EXPECT_EQ(parse_length("3cm", Unit::metre), 0.03);
  const std::pair<std::string, std::string> rows[] = {
      {"", "'' is not a length such as 0.05, 1mm or 0.5in"},
      {"mm", "'mm' is not a length such as 0.05, 1mm or 0.5in"},
      {"nan", "'nan' is not a length such as 0.05, 1mm or 0.5in"},
      {"inf", "'inf' is not a length such as 0.05, 1mm or 0.5in"},
      {"1e999", "'1e999' is not a length such as 0.05, 1mm or 0.5in"},
      {"-1mm", "a length must be positive, not '-1mm'"},
      {"0", "a length must be positive, not '0'"},
      {"0,05", "'0,05' is not a length such as 0.05, 1mm or 0.5in"},
      {"1,5mm", "'1,5mm' is not a length such as 0.05, 1mm or 0.5in"},
      {"0x1p-3", "'0x1p-3' is not a length such as 0.05, 1mm or 0.5in"},
      {"1 mm", "the unit must be mm, cm, m, in or ft, not ' mm'"},
      {"1parsec", "the unit must be mm, cm, m, in or ft, not 'parsec'"},
  };
  for (const auto& [text, message] : rows) {
    try {
      (void)parse_length(text, Unit::millimetre);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.message(), message);
      EXPECT_EQ(error.code(), Errc::invalid_argument);
    }
  }
}

TEST(Unit, lengths_no_number_of_the_other_unit_holds_are_refused) {
  EXPECT_EQ(parse_length("1e308mm", Unit::metre), 1e305);  // though ten times it is none
  EXPECT_EQ(parse_length("5e-324mm", Unit::millimetre), 5e-324);
  const auto said = [](const std::string& text, Unit unit) {
    return test::message_of([&] { (void)parse_length(text, unit); }, Errc::invalid_argument);
  };
  EXPECT_EQ(said("1e308ft", Unit::millimetre),
            "'1e308ft' in mm is more than 1.7976931348623157e+308, the largest number");
  EXPECT_EQ(said("1e-323mm", Unit::metre),
            "'1e-323mm' in m is less than 5e-324, the smallest number");
}

TEST(Unit, names_and_symbols_go_round) {
  for (const auto unit :
       {Unit::millimetre, Unit::centimetre, Unit::metre, Unit::inch, Unit::foot}) {
    EXPECT_EQ(unit_from(symbol(unit)), unit);
  }
  EXPECT_EQ(millimetres(Unit::inch), 25.4);
  EXPECT_EQ(millimetres(Unit::foot), 304.8);
}

}  // namespace
}  // namespace dupin
