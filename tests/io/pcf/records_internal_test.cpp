#include <gtest/gtest.h>

#include "pcf/records.h"

namespace dupin::pcf {
namespace {

TEST(PcfRecords, belong_to_the_line_that_is_not_indented) {
  const auto all = records("UNITS-BORE MM\nPIPE\n    END-POINT 1 2 3 4\n    SKEY PIPW\nELBOW\n");
  ASSERT_EQ(all.size(), 3);
  EXPECT_EQ(all[0].head.keyword, "UNITS-BORE");
  EXPECT_EQ(all[0].head.text, "MM");
  EXPECT_EQ(all[1].head.line, 2);
  ASSERT_EQ(all[1].attributes.size(), 2);
  EXPECT_EQ(all[1].attributes[0].keyword, "END-POINT");
  EXPECT_EQ(all[1].attributes[0].text, "1 2 3 4");
  EXPECT_EQ(all[1].attributes[1].line, 4);
  EXPECT_EQ(all[2].head.line, 5);
}

TEST(PcfRecords, are_told_in_any_spelling) {
  const auto all = records(
      "\xEF\xBB\xBF  UNITS-CO-ORDS MM\r\n pipe\r\n\tEndpoint 1 2 3\r\n  <SKEY> PIPW\r\n"
      "  CENTER-POINT 0 0 0\r\n\r\nBEND\r    BEND-RADIUS 5\r    Skey x");
  ASSERT_EQ(all.size(), 3);
  EXPECT_EQ(all[1].head.keyword, "PIPE");
  ASSERT_EQ(all[1].attributes.size(), 3);
  EXPECT_EQ(all[1].attributes[0].keyword, "END-POINT");
  EXPECT_EQ(all[1].attributes[1].keyword, "SKEY");
  EXPECT_EQ(all[1].attributes[2].keyword, "CENTRE-POINT");
  EXPECT_EQ(all[2].head.line, 7);
  ASSERT_EQ(all[2].attributes.size(), 2);
  EXPECT_EQ(all[2].attributes[0].keyword, "BEND-RADIUS");
  EXPECT_EQ(all[2].attributes[0].line, 8);
}

// Some programs write text as text twice.
TEST(PcfRecords, are_of_lines_that_end_in_several_crs_and_one_lf) {
  const auto all =
      records("UNITS-CO-ORDS MM\r\r\nPIPE\r\r\n  END-POINT 1 2 3\r\r\r\n  SKEY x\r\r\nBEND\r\r\n");
  ASSERT_EQ(all.size(), 3);
  EXPECT_EQ(all[1].head.line, 2);
  ASSERT_EQ(all[1].attributes.size(), 2);
  EXPECT_EQ(all[1].attributes[0].text, "1 2 3");
  EXPECT_EQ(all[1].attributes[1].line, 4);
  EXPECT_EQ(all[2].head.line, 5);
}

TEST(PcfRecords, keep_the_free_text_of_messages) {
  const auto all = records("MESSAGE-SQUARE\n  TEXT a\nIT SAYS PIPES\nPIPE\n");
  ASSERT_EQ(all.size(), 2);
  EXPECT_EQ(all[0].attributes.size(), 2);
}

TEST(PcfRecords, tell_text_of_messages_from_components_by_how_it_is_indented) {
  for (const char* text : {"MESSAGE-SQUARE\n    PIPE TO BE FIELD CUT\nPIPE\n",
                           "MESSAGE-SQUARE\n    CO-ORDS 0 0 0\n    SUPPORT BY OTHERS\nPIPE\n",
                           " MESSAGE-CIRCLE\n  PIPE\n  VALVE\n PIPE\n  END-POINT 1 2 3\n",
                           "MESSAGE-SQUARE\n  WELD\n  PIPE\n    END-POINT 1 2 3\n"}) {
    const auto all = records(text);
    ASSERT_EQ(all.size(), 2) << text;
    EXPECT_TRUE(all[0].head.keyword.starts_with("MESSAGE")) << text;
    EXPECT_EQ(all[1].head.keyword, "PIPE") << text;
  }
  EXPECT_EQ(records(" MESSAGE-SQUARE\n text\n PIPE\n END-POINT 1 2 3\n").size(), 2);
}

TEST(PcfRecords, say_where_their_text_begins) {
  const std::string text = "PIPE\n  END-POINT  17 2 3\n";
  const auto all = records(text);
  EXPECT_EQ(text.substr(all[0].attributes[0].position, 4), "  17");
}

TEST(PcfRecords, are_components_settings_skipped_or_unknown) {
  for (const char* keyword :
       {"PIPE", "ELBOW", "TEE-STUB", "VALVE-3WAY", "FLANGE-BLIND", "REDUCER-ECCENTRIC",
        "INSTRUMENT-DIAL", "MISC-COMPONENT", "Y-PIECE-FITTING"}) {
    EXPECT_EQ(head_kind(keyword), HeadKind::component) << keyword;
  }
  for (const char* keyword : {"SUPPORT", "MESSAGE-SQUARE", "MATERIALS", "WELD", "BOLT"}) {
    EXPECT_EQ(head_kind(keyword), HeadKind::skipped) << keyword;
  }
  EXPECT_EQ(head_kind("UNITS-BORE"), HeadKind::setting);
  EXPECT_EQ(head_kind("PIPELINE-REFERENCE"), HeadKind::setting);
  EXPECT_EQ(head_kind("PIPEWORK"), HeadKind::unknown);
  EXPECT_EQ(head_kind(""), HeadKind::unknown);
}

TEST(PcfRecords, may_begin_with_a_number) {
  EXPECT_EQ(leading_number("9000"), 9000);
  EXPECT_EQ(leading_number("-45.5 deg"), -45.5);
  for (const char* text : {"", "none", "nan", "inf", "1e999"}) {
    EXPECT_FALSE(leading_number(text)) << text;
  }
}

}  // namespace
}  // namespace dupin::pcf
