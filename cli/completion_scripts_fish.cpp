#include <CLI/App.hpp>

#include "completion_scripts.h"
#include "option_list.h"

namespace dupin::cli {
namespace {

std::string quoted(const std::string& text) { return "'" + marked(text, "\\'", "\\") + "'"; }

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

/// A line for an option of a command, or of all where `condition` is empty.
std::string line_of(const OptionInfo& option, const std::string& condition) {
  std::string line = "complete -c dupin" + condition;
  for (const std::string& name : option.short_names) {
    line += " -s " + name;
  }
  for (const std::string& name : option.long_names) {
    line += " -l " + name;
  }
  if (!option.choices.empty()) {
    line += " -x -a " + quoted(joined(option.choices));
  } else if (option.takes_file()) {
    line += " -r -F";
  } else if (!option.is_flag()) {
    line += " -x";
  }
  return line + " -d " + quoted(option.text) + "\n";
}

}  // namespace

std::string fish_completion(const CLI::App& app) {
  std::string script =
      "# fish completion for dupin: dupin completion fish > "
      "~/.config/fish/completions/dupin.fish\n"
      "complete -c dupin -e\n"
      "complete -c dupin -n __fish_use_subcommand -f\n";
  for (const OptionInfo& option : options_of(app)) {
    script += line_of(option, "");
  }
  for (const CLI::App* command : commands_of(app)) {
    const std::string& name = command->get_name();
    const std::string condition = " -n '__fish_seen_subcommand_from " + name + "'";
    script += "complete -c dupin -n __fish_use_subcommand -a " + name + " -d " +
              quoted(command->get_description()) + "\n";
    for (const OptionInfo& option : options_of(*command)) {
      if (option.positional.empty()) {
        script += line_of(option, condition);
      } else if (!option.choices.empty()) {
        script +=
            "complete -c dupin" + condition + " -f -a " + quoted(joined(option.choices)) + "\n";
      }
    }
  }
  return script;
}

}  // namespace dupin::cli
