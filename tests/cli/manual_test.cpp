#include <string>

#include <gtest/gtest.h>

#include "cli/tool.h"

namespace dupin::test {
namespace {

using Manual = Tool;

TEST_F(Manual, has_every_option_of_a_command) {
  const std::string page = dupin({"manual", "build"}).out;
  EXPECT_TRUE(page.starts_with(".TH DUPIN\\-BUILD 1"));
  for (const char* const part :
       {".SH NAME\ndupin\\-build \\- Make a watertight solid",
        "\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIOUT\\fR",
        ".SH EXAMPLES\n.EX\ndupin build examples/reducer.json", "\\fB\\-\\-json\\fR",
        "one of \\fBouter\\fR \\fBmetal\\fR \\fBfluid\\fR"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part << "\n" << page;
  }
}

TEST_F(Manual, of_the_tool_lists_the_commands) {
  const std::string page = dupin({"manual"}).out;
  EXPECT_NE(page.find("\\fBdupin\\-check\\fR(1)"), std::string::npos) << page;
  EXPECT_NE(page.find("Exit codes: 0 ok"), std::string::npos) << page;
  EXPECT_EQ(dupin({"manual", "unite"}).exit_code, 2);
}

TEST_F(Manual, is_what_roff_reads_without_a_warning) {
  const ProcessResult result = shell(
      "command -v groff > /dev/null || exit 0; for c in build boolean convert completion; do "
      "dupin manual $c | groff -man -Tutf8 -ww -z 2>&1; done");
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

}  // namespace
}  // namespace dupin::test
