#include <CLI/App.hpp>

#include "completion_scripts.h"
#include "option_list.h"

namespace dupin::cli {
namespace {

/// Inside single quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char character : text) {
    result += character == '\'' ? std::string("'\\''") : std::string(1, character);
  }
  return result + "'";
}

/// What comes after an option: ":LENGTH: ", ":OUT:_files", ":NAME:(off stl)".
std::string action_of(const OptionInfo& option) {
  if (option.is_flag()) {
    return "";
  }
  std::string action = ":" + marked(option.value, ":", "\\") + ":";
  if (option.takes_file()) {
    return action + "_files";
  }
  if (option.choices.empty()) {
    return action + " ";
  }
  action += "(";
  for (const std::string& choice : option.choices) {
    action += (action.back() == '(' ? "" : " ") + choice;
  }
  return action + ")";
}

/// One line for each name of each option, for _arguments.
std::string specifications(const CLI::App& command) {
  std::string lines;
  for (const OptionInfo& option : options_of(command)) {
    if (!option.positional.empty()) {
      continue;
    }
    std::vector<std::string> names;
    for (const std::string& name : option.short_names) {
      names.push_back("-" + name);
    }
    for (const std::string& name : option.long_names) {
      names.push_back("--" + name);
    }
    std::string others;
    for (const std::string& name : names) {
      others += (others.empty() ? "" : " ") + name;
    }
    for (const std::string& name : names) {
      lines +=
          " \\\n        " + quoted((option.repeated ? "*" : "(" + others + ")") + name + "[" +
                                   marked(option.text, "[]\\:", "\\") + "]" + action_of(option));
    }
  }
  return lines;
}

/// What stands without a dash: a choice, or files.
std::string positionals(const CLI::App& command) {
  for (const OptionInfo& option : options_of(command)) {
    if (!option.positional.empty() && !option.choices.empty()) {
      std::string words;
      for (const std::string& choice : option.choices) {
        words += (words.empty() ? "" : " ") + choice;
      }
      return " \\\n        " + quoted("*:" + option.positional + ":(" + words + ")");
    }
  }
  return " \\\n        '*:file:_files'";
}

}  // namespace

std::string zsh_completion(const CLI::App& app) {
  std::string commands, cases;
  for (const CLI::App* command : commands_of(app)) {
    commands += "    " +
                quoted(command->get_name() + ":" + marked(command->get_description(), ":", "\\")) +
                "\n";
    cases += "      " + command->get_name() + ")\n        _arguments -s" +
             specifications(*command) + specifications(app) + positionals(*command) + " ;;\n";
  }
  return R"(#compdef dupin
# zsh completion for dupin: as _dupin in a folder of $fpath, or source <(dupin completion zsh)
_dupin() {
  local -a commands
  commands=(
)" + commands +
         R"(  )
  local word command="" place=2
  for word in "${(@)words[2,CURRENT-1]}"; do
    [[ $word == -* ]] || { command=$word; break }
    (( place++ ))
  done
  if [[ -z $command ]]; then
    if [[ $words[CURRENT] == -* ]]; then
      _arguments -s)" +
         specifications(app) + R"(
    else
      _describe -t commands command commands
    fi
    return
  fi
  words=("${(@)words[place,-1]}")
  (( CURRENT -= place - 1 ))
  case $command in
)" + cases +
         R"(  esac
}
if [[ $zsh_eval_context[-1] == loadautofunc ]]; then
  _dupin "$@"
else
  compdef _dupin dupin
fi
)";
}

}  // namespace dupin::cli
