#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/tool.h"

namespace dupin::test {
namespace {

using Completion = Tool;

/// What bash would offer after these words, the last of which is still being typed.
std::string completer(const std::vector<std::string>& words) {
  std::string quoted;
  for (const std::string& word : words) {
    quoted += "'" + word + "' ";
  }
  return "source <(dupin completion bash); complete -p dupin > /dev/null || exit 9; COMP_WORDS=(" +
         quoted + "); COMP_CWORD=" + std::to_string(words.size() - 1) +
         "; _dupin; echo \"${COMPREPLY[*]}\"";
}

TEST_F(Completion, offers_commands_options_values_and_files) {
  folder_.write("part one.off", "");
  folder_.write("plant.json", "");
  const std::vector<std::pair<std::vector<std::string>, std::string>> table{
      {{"dupin", "c"}, "check certify convert completion"},
      {{"dupin", "--ve"}, "--version"},
      {{"dupin", "--json", "sub"}, "subtract"},
      {{"dupin", "boolean", "--rep"}, "--repair"},
      {{"dupin", "boolean", "a + b", "a", "=", "part"}, "part one.off"},
      {{"dupin", "certify", "--m"}, "--margin"},
      {{"dupin", "verify", "pl"}, "plant.json"},
      {{"dupin", "union", "--c"}, "--contacts --cross-check"},
      {{"dupin", "union", "--tim"}, "--timing"},
      {{"dupin", "build", "--s"}, "--solids --segments --snap --schedule --strict"},
      {{"dupin", "check", "--q"}, "--quiet"},
      {{"dupin", "edit", "--rot"}, "--rotate"},
      {{"dupin", "convert", "--sc"}, "--scale --schedule"},
      {{"dupin", "convert", "--translate", ""}, ""},
      {{"dupin", "convert", "--format", "st"}, "stl-ascii stl"},
      {{"dupin", "union", "--contacts", ""}, "report refuse separate= bridge="},
      {{"dupin", "completion", ""}, "bash"},
      {{"dupin", "check", "part"}, "part one.off"},
      {{"dupin", "build", "pl"}, "plant.json"},
      {{"dupin", "gaps", "--connect", ""}, ""},
  };
  for (const auto& [words, offered] : table) {
    const ProcessResult result = shell(completer(words));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, offered + "\n") << words.back();
  }
}

}  // namespace
}  // namespace dupin::test
