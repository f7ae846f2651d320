#include "exit_code.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/tool.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

TEST(ExitCode, every_error_code_has_one) {
  using cli::ExitCode;
  const std::vector<std::pair<Errc, ExitCode>> table{
      {Errc::invalid_argument, ExitCode::input},   {Errc::not_closed, ExitCode::input},
      {Errc::not_manifold, ExitCode::input},       {Errc::not_oriented, ExitCode::input},
      {Errc::self_intersecting, ExitCode::input},  {Errc::irregular_surface, ExitCode::refused},
      {Errc::infeasible_blend, ExitCode::refused}, {Errc::boolean_failed, ExitCode::refused},
      {Errc::contact, ExitCode::refused},          {Errc::unroundable, ExitCode::refused},
      {Errc::limit_exceeded, ExitCode::input},     {Errc::cancelled, ExitCode::refused},
      {Errc::parse_failed, ExitCode::input},       {Errc::io_failed, ExitCode::input},
      {Errc::internal, ExitCode::internal}};
  for (const auto& [code, expected] : table) {
    EXPECT_EQ(cli::exit_code(code), expected) << name(code);
  }
}

using ToolExitCode = Tool;

TEST_F(ToolExitCode, zero_when_all_is_well) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(dupin({"check", "a.off"}).exit_code, 0);
}

TEST_F(ToolExitCode, one_for_findings) {
  put("a.off", open_box());
  EXPECT_EQ(dupin({"check", "a.off"}).exit_code, 1);
  EXPECT_EQ(dupin({"gaps", "a.off"}).exit_code, 1);
}

TEST_F(ToolExitCode, two_for_a_command_line_without_sense) {
  EXPECT_EQ(dupin({"check"}).exit_code, 2);
}

TEST_F(ToolExitCode, three_for_input_that_is_missing_or_wrong) {
  put("open.off", open_box());
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(dupin({"check", "missing.off"}).exit_code, 3);
  EXPECT_EQ(dupin({"union", "a.off", "open.off", "-o", "b.off"}).exit_code, 3);
  folder_.write("a.json", "{}");
  EXPECT_EQ(dupin({"build", "a.json", "-o", "b.off"}).exit_code, 3);
}

TEST_F(ToolExitCode, four_for_what_has_no_valid_result) {
  EXPECT_EQ(dupin({"build", example("tight.json"), "-o", "b.off"}).exit_code, 4);
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  put("b.off", box({1, 1, 0}, {2, 2, 1}));
  EXPECT_EQ(dupin({"union", "a.off", "b.off", "-o", "c.off", "--contacts", "refuse"}).exit_code, 4);
  put("touching.off", joined({box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})}));
  for (const std::string policy : {"refuse", "separate=1e-30", "bridge=1e-30", "separate=3"}) {
    EXPECT_EQ(dupin({"repair", "touching.off", "-o", "c.off", "--contacts", policy}).exit_code, 4)
        << policy;
  }
}

TEST_F(ToolExitCode, five_when_the_result_cannot_be_written) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  put("b.off", box({2, 0, 0}, {3, 1, 1}));
  EXPECT_EQ(dupin({"convert", "a.off", "missing/b.off"}).exit_code, 5);
  EXPECT_EQ(dupin({"union", "a.off", "b.off", "-o", "missing/b.off"}).exit_code, 5);
  EXPECT_EQ(shell("dupin convert a.off - --format off > /dev/full").exit_code, 5);
  EXPECT_EQ(shell("dupin check a.off > /dev/full").exit_code, 5);
  EXPECT_EQ(shell("dupin check - < /").exit_code, 3);
  EXPECT_EQ(shell("dupin check - <&-").exit_code, 3);
}

TEST_F(ToolExitCode, seventy_when_memory_runs_out) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitiser itself reserves terabytes";
#endif
  put("a.off", tube(1, 0, 1, 20000));
  EXPECT_EQ(shell("ulimit -v 50000; dupin check a.off").exit_code, 70);
}

}  // namespace
}  // namespace dupin::test
