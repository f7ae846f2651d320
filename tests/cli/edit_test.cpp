#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tool.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

using Edit = Tool;

TEST_F(Edit, says_which_pieces_changed) {
  const ProcessResult result =
      dupin({"edit", example("crane-hook.json"), "--move", "4=1.1,2.5,0.2,0.8", "-o", "new.json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("changed pieces       1, 2, 3 of 0 to 5\n"));
  const auto report = json({"edit", example("crane-hook.json"), "--move", "6=2.1,0.9,0.1,0.97",
                            "--on-locus", "-o", "new.json"},
                           0);
  EXPECT_EQ(report.at("changed"), nlohmann::json::parse("[2, 3]"));
  EXPECT_EQ(report.at("spheres").size(), 1);
  EXPECT_EQ(dupin({"build", "new.json", "-o", "new.stl", "-q"}).exit_code, 0);
}

TEST_F(Edit, writes_to_standard_output) {
  const ProcessResult result =
      dupin({"edit", example("crane-hook.json"), "--twist", "6=25", "-o", "-", "-q"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(dupin({"info", "-"}, result.out).exit_code, 0);
}

TEST_F(Edit, a_refused_edit_leaves_no_file) {
  const std::string hook = example("crane-hook.json");
  EXPECT_EQ(dupin({"edit", hook, "--move", "4=0,4,0,4", "-o", "new.json"}).exit_code, 4);
  EXPECT_EQ(dupin({"edit", hook, "--move", "99=0,4,0,4", "-o", "new.json"}).exit_code, 3);
  for (const std::string typed :
       {"4=1,2,3", "4=1,2,3,x", "=1,2,3,4", "4=1,2,3,4,5", "4=1,2,3,nan"}) {
    const ProcessResult result = dupin({"edit", hook, "--move", typed, "-o", "new.json"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("--move takes SPHERE=X,Y,Z,RADIUS, not '" + typed + "'"));
  }
  EXPECT_EQ(dupin({"edit", hook, "-o", "new.json"}).exit_code, 2);
  EXPECT_THAT(folder_.files(), IsEmpty());
}

}  // namespace
}  // namespace dupin::test
