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

TEST(Length, beside_meshes_may_be_in_microns) {
  EXPECT_EQ(mesh_length("5", 7, "um"), 5);
  EXPECT_EQ(mesh_length("5um", 7, "um"), 5);
  EXPECT_EQ(mesh_length("5mm", 7, "um"), 5000);
  EXPECT_EQ(mesh_length("1in", 7, "um"), 25400);
  EXPECT_EQ(mesh_length("500um", 7, "mm"), 0.5);
  EXPECT_EQ(mesh_length("25400um", 7, "in"), 1);
  EXPECT_EQ(mesh_length("500um", 7, ""), 0.5);
  for (const std::string text : {"um", "-1um", "0um", "1mum", "0mm", "wide", "1yd"}) {
    EXPECT_THROW((void)mesh_length(text, 0, "um"), UsageError) << text;
    EXPECT_THROW((void)mesh_length(text, 0, "mm"), UsageError) << text;
  }
}

TEST(Length, in_the_place_of_a_documents_is_within_its_bounds_and_blames_the_option) {
  EXPECT_EQ(document_length("--wall", Unit::inch, "25.4mm", 7), 1);
  EXPECT_EQ(document_length("--wall", Unit::inch, "", 1e-30), 1e-30) << "not of the option";
  for (const std::string text : {"1e-30", "9e-13", "1.1e12", "1e300"}) {
    try {
      (void)document_length("--wall", Unit::metre, text, 0);
      ADD_FAILURE() << text;
    } catch (const UsageError& error) {
      EXPECT_EQ(std::string(error.what()),
                "--wall " + text + " is out of range: in m, lengths are between 1e-12 and 1e12");
    }
  }
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
