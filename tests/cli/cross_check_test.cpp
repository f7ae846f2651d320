#include "dupin/kernel/cross_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

/// Runs the tool with --cross-check; a build without the engines has only its refusal.
class CrossCheckOption : public Tool {
 protected:
  void SetUp() override {
    if (!has_cross_check()) {
      GTEST_SKIP() << "built without the engines";
    }
    put("a.off", box({0, 0, 0}, {2, 2, 2}));
    put("b.off", box({1, 1, 1}, {3, 3, 3}));
    put("beside.off", box({2, 2, 0}, {4, 4, 2}));
  }
};

TEST_F(CrossCheckOption, agrees_on_every_operation) {
  const struct {
    const char* command;
    double volume;
  } table[] = {{"union", 15}, {"intersect", 1}, {"subtract", 7}};
  for (const std::string engine : {"nef", "corefinement"}) {
    for (const auto& [command, volume] : table) {
      const auto check =
          json({command, "a.off", "b.off", "-o", "out.off", "--cross-check", engine}, 0)
              .at("cross_check");
      EXPECT_EQ(check.at("engine"), engine);
      EXPECT_EQ(check.at("verdict"), "agrees");
      EXPECT_EQ(check.at("volume"), volume);
      EXPECT_EQ(check.at("other_volume"), volume);
      EXPECT_EQ(check.at("volume_difference"), 0);
      EXPECT_TRUE(check.at("place").is_null());
      EXPECT_TRUE(check.at("failure").is_null());
    }
    const ProcessResult expression =
        dupin({"boolean", "(x + y) - z", "x=a.off", "y=b.off", "z=beside.off", "-o", "out.off",
               "--cross-check", engine});
    EXPECT_EQ(expression.exit_code, 0);
    EXPECT_THAT(expression.out, HasSubstr("cross-check          " + engine + " agrees, exactly\n"));
  }
}

TEST_F(CrossCheckOption, is_only_told_of_where_it_was_asked_for) {
  EXPECT_FALSE(json({"union", "a.off", "b.off", "-o", "out.off"}, 0).contains("cross_check"));
}

TEST_F(CrossCheckOption, says_why_the_other_engine_failed_and_writes_all_the_same) {
  const std::vector<std::string> command = {"union", "a.off",         "beside.off",  "-o",
                                            "o.off", "--cross-check", "corefinement"};
  const auto check = json(command, 0).at("cross_check");
  EXPECT_EQ(check.at("verdict"), "engine_failed");
  EXPECT_EQ(check.at("volume"), 16);
  EXPECT_TRUE(check.at("other_volume").is_null());
  EXPECT_EQ(check.at("failure"),
            "'unite' by corefinement refuses a result that touches itself along an edge");
  EXPECT_THAT(dupin(command).out,
              HasSubstr("cross-check          corefinement failed and has no opinion: 'unite' by"));
  EXPECT_THAT(folder_.files(), testing::Contains("o.off"));
  EXPECT_EQ(json({"union", "a.off", "beside.off", "-o", "o.off", "--cross-check", "nef"}, 0)
                .at("cross_check")
                .at("verdict"),
            "agrees");
}

TEST_F(CrossCheckOption, checks_the_union_of_the_pieces_that_build_makes) {
  for (const std::string engine : {"nef", "corefinement"}) {
    const auto report = json({"build", example("header.json"), "-o", "header.off", "--segments",
                              "16", "--cross-check", engine},
                             0);
    EXPECT_GT(report.at("pieces"), 1);
    const auto& check = report.at("output").at("cross_check");
    EXPECT_EQ(check.at("verdict"), "agrees");
    EXPECT_NEAR(check.at("volume"), report.at("output").at("check").at("volume"), 1e-6);
  }
}

TEST_F(CrossCheckOption, takes_no_other_engine) {
  const std::vector<std::vector<std::string>> commands = {
      {"union", "a.off", "b.off", "-o", "out.off", "--cross-check", "cork"},
      {"boolean", "a", "a=a.off", "-o", "out.off", "--cross-check", "cork"},
      {"build", example("header.json"), "-o", "out.off", "--cross-check", "cork"}};
  for (const auto& command : commands) {
    const ProcessResult result = dupin(command);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err,
              "dupin: --cross-check takes nef or corefinement, not 'cork' (see dupin --help)\n");
  }
}

using CrossCheckAbsent = Tool;

TEST_F(CrossCheckAbsent, is_said_before_anything_is_done) {
  if (has_cross_check()) {
    GTEST_SKIP() << "built with the engines";
  }
  const ProcessResult result =
      dupin({"union", "none.off", "none.off", "-o", "out.off", "--cross-check", "nef"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("this build has no other engines"));
}

}  // namespace
}  // namespace dupin::test
