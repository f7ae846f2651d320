#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/kernel/cross_check.h"
#include "support/source_folder.h"

namespace dupin::test {
namespace {

using Docs = Tool;

/// A line after "$ " and the lines that it prints.
struct Example {
  std::size_t line = 0;
  std::string command;
  std::vector<std::string> output;
};

/// The examples in a document's console blocks.
std::vector<Example> examples(const std::string& document) {
  std::ifstream stream(source_folder() / document);
  std::vector<Example> found;
  bool inside = false;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    if (line.starts_with("```")) {
      inside = line == "```console";
    } else if (inside && line.starts_with("$ ")) {
      found.push_back({number, line.substr(2), {}});
    } else if (inside && !found.empty()) {
      found.back().output.push_back(line);
    }
  }
  return found;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// "..." stands for any text.
bool fits(std::string_view pattern, std::string_view text) {
  const std::size_t dots = pattern.find("...");
  if (dots == std::string_view::npos || pattern.substr(0, dots) != text.substr(0, dots)) {
    return pattern == text;
  }
  pattern.remove_prefix(dots + 3);
  for (text.remove_prefix(std::min(dots, text.size())); !fits(pattern, text);
       text.remove_prefix(1)) {
    if (text.empty()) {
      return false;
    }
  }
  return true;
}

/// Line by line; a line of "..." stands for any number of lines.
bool fit(const std::vector<std::string>& patterns, const std::vector<std::string>& lines,
         std::size_t pattern = 0, std::size_t line = 0) {
  if (pattern == patterns.size()) {
    return line == lines.size();
  }
  if (patterns[pattern] == "...") {
    for (std::size_t next = line; next <= lines.size(); ++next) {
      if (fit(patterns, lines, pattern + 1, next)) {
        return true;
      }
    }
    return false;
  }
  return line < lines.size() && fits(patterns[pattern], lines[line]) &&
         fit(patterns, lines, pattern + 1, line + 1);
}

TEST_F(Docs, examples_of_the_manual_print_what_it_says) {
  const std::vector<Example> manual = examples("docs/cli.md");
  EXPECT_GE(manual.size(), 12);
  for (const Example& example : manual) {
    if (example.command.find("--cross-check") != std::string::npos && !has_cross_check()) {
      continue;  // a build without the other engines
    }
    const ProcessResult result = shell("{ " + example.command + "; } 2>&1");
    EXPECT_TRUE(fit(example.output, lines_of(result.out)))
        << "docs/cli.md:" << example.line << ": $ " << example.command << "\nprints\n"
        << result.out;
  }
}

/// A block of commands and, where one follows it, the block of what they print.
struct Script {
  std::size_t line = 0;
  std::string commands;
  std::vector<std::string> output;
  bool has_output = false;
};

/// The sh blocks of a document, each with the text block right after it.
std::vector<Script> scripts(const std::string& document) {
  std::ifstream stream(source_folder() / document);
  std::vector<Script> found;
  std::string block, line, before;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    if (line.starts_with("```")) {
      block = block.empty() ? line.substr(3) + " " : "";
      if (block == "sh ") {
        found.push_back({number, {}, {}});
      } else if (block == "text " && before == "```" && !found.empty()) {
        found.back().has_output = true;
      }
    } else if (block == "sh ") {
      found.back().commands += line + "\n";
    } else if (block == "text " && !found.empty()) {
      found.back().output.push_back(line);
    }
    before = line;
  }
  return found;
}

TEST_F(Docs, steps_of_the_tutorial_work_and_print_what_it_says) {
  const std::vector<Script> steps = scripts("docs/tutorial.md");
  EXPECT_GE(steps.size(), 7);
  for (const Script& step : steps) {
    // The first one enters its own folder.
    const std::string enter = step.line == steps.front().line ? "" : "cd build/tutorial\n";
    const ProcessResult result = shell("{ set -e\n" + enter + step.commands + "} 2>&1");
    EXPECT_EQ(result.exit_code, 0) << "docs/tutorial.md:" << step.line << "\n" << result.out;
    EXPECT_TRUE(!step.has_output || fit(step.output, lines_of(result.out)))
        << "docs/tutorial.md:" << step.line << " prints\n"
        << result.out;
  }
}

TEST_F(Docs, every_line_of_the_tool_in_the_readme_runs_from_a_fresh_checkout) {
  std::vector<std::string> lines;
  for (const Script& script : scripts("README.md")) {
    if (script.commands.find("dupin build") != std::string::npos) {
      lines = lines_of(script.commands);
    }
  }
  EXPECT_GE(lines.size(), 15);
  for (const std::string& line : lines) {
    // What waits for Ctrl-C gets it.
    const bool waits = line.starts_with("dupin watch");
    const ProcessResult result =
        shell(waits ? "timeout -s INT 5 " + tool_path() + line.substr(5) : line);
    EXPECT_EQ(result.exit_code, waits ? 124 : 0) << line << "\n" << result.out << result.err;
  }
}

TEST_F(Docs, patterns_fit_only_what_they_say) {
  EXPECT_TRUE(fit({"volume ... mm^3"}, {"volume 12 mm^3"}));
  EXPECT_FALSE(fit({"volume ... mm^3"}, {"volume 12 in^3"}));
  EXPECT_TRUE(fit({"... (a, ...)"}, {"box (a, b)"}));
  EXPECT_FALSE(fit({"... (a, ...)"}, {"box (b, a"}));
  EXPECT_TRUE(fit({"a", "...", "d"}, {"a", "b", "c", "d"}));
  EXPECT_FALSE(fit({"a", "...", "d"}, {"a", "b", "c"}));
  EXPECT_FALSE(fit({"a"}, {"a", "b"}));
}

}  // namespace
}  // namespace dupin::test
