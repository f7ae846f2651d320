#include <cstdlib>
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
      {{"dupin", "build", "--s"}, "--size --sharp --solids --segments --snap --schedule --strict"},
      {{"dupin", "check", "--q"}, "--quiet"},
      {{"dupin", "edit", "--rot"}, "--rotate"},
      {{"dupin", "convert", "--sc"}, "--scale --schedule"},
      {{"dupin", "convert", "--translate", ""}, ""},
      {{"dupin", "convert", "--format", "st"}, "stl-ascii stl"},
      {{"dupin", "union", "--contacts", ""}, "report refuse separate= bridge="},
      {{"dupin", "completion", ""}, "bash zsh fish"},
      {{"dupin", "schema", ""}, "assembly certificate"},
      {{"dupin", "manual", "bo"}, "boolean bom"},
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

/// Whether a shell is there to ask.
bool has(const std::string& shell) {
  return std::system(("command -v " + shell + " > /dev/null").c_str()) == 0;
}

TEST_F(Completion, fish_offers_what_bash_does) {
  if (!has("fish")) {
    GTEST_SKIP() << "no fish";
  }
  folder_.write("plant.json", "");
  const std::vector<std::pair<std::string, std::string>> table{
      {"dupin chec", "check"},
      {"dupin union --contac", "--contacts"},
      {"dupin convert --format st", "stl stl-ascii"},
      {"dupin completion z", "zsh"},
      {"dupin build pl", "plant.json"},
      {"dupin certify -o pl", "plant.json"},
      {"dupin check --verif", ""},
      {"dupin build --tolerance pl", ""},
  };
  for (const auto& [line, offered] : table) {
    const ProcessResult result = shell(
        "dupin completion fish > c.fish; HOME=$PWD XDG_CONFIG_HOME=$PWD fish -N -c "
        "'source c.fish; complete -C \"" +
        line + "\"' | cut -f1 | sort | tr '\n' ' ' | sed 's/ $//'");
    EXPECT_EQ(result.out, offered) << line << result.err;
  }
}

TEST_F(Completion, zsh_asks_for_the_options_of_the_command) {
  if (!has("zsh")) {
    GTEST_SKIP() << "no zsh";
  }
  // Instead of a terminal, what the function asks zsh's own to offer.
  const std::string prelude =
      "dupin completion zsh > _dupin; cat > ask.zsh << 'END'\n"
      "compdef() { :; }\n"
      "_arguments() { print -l -- \"$@\"; }\n"
      "_describe() { print -l -- \"${(@P)4}\"; }\n"
      "source ./_dupin\n"
      "words=(\"$@\"); CURRENT=$#; _dupin\n"
      "END\n";
  const std::vector<std::pair<std::string, std::string>> table{
      {"dupin ''", "check:Say whether a mesh is a solid"},
      {"dupin --json ''", "build:Make a watertight solid"},
      {"dupin build ''", "(-o --output)--output["},
      {"dupin build -q ''", "*:file:_files"},
      {"dupin union ''", "--contacts["},
      {"dupin convert --format ''", "stl-ascii"},
      {"dupin completion ''", "*:SHELL:(bash zsh fish)"},
      {"dupin -''", "(--version)--version["},
  };
  for (const auto& [line, said] : table) {
    const ProcessResult result = shell(prelude + "zsh -f ask.zsh " + line);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find(said), std::string::npos) << line << "\n" << result.out << result.err;
  }
}

}  // namespace
}  // namespace dupin::test
