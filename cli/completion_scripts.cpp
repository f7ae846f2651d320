#include "completion_scripts.h"

#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "option_list.h"
#include "output.h"

namespace dupin::cli {
namespace {

/// All long and short option names of a command, separated by spaces.
std::string option_words(const CLI::App& app) {
  std::string words;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) {  // hidden
      continue;
    }
    for (const std::string& name : option->get_snames()) {
      words += "-" + name + " ";
    }
    for (const std::string& name : option->get_lnames()) {
      words += "--" + name + " ";
    }
  }
  return words;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::string commands;
  std::string cases;
  for (const CLI::App* command : commands_of(app)) {
    commands += command->get_name() + " ";
    cases += "    " + command->get_name() + ") words=\"" + option_words(*command) +
             option_words(app) + "\" ;;\n";
  }
  return R"(# bash completion for dupin: source <(dupin completion bash)
_dupin() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command="" words="" i
  for ((i = 1; i < COMP_CWORD; i++)); do
    case ${COMP_WORDS[i]} in -*) ;; *) command=${COMP_WORDS[i]}; break ;; esac
  done
  COMPREPLY=()
  case $previous in
    --format) COMPREPLY=($(compgen -W ")" +
         joined(format_names()) + R"(" -- "$word")); return ;;
    --contacts) COMPREPLY=($(compgen -W "report refuse separate= bridge=" -- "$word")); return ;;
    --cross-check) COMPREPLY=($(compgen -W "nef corefinement" -- "$word")); return ;;
    --origin) COMPREPLY=($(compgen -W "keep auto" -- "$word")); return ;;
    --tolerance|--rounding-tolerance|--connect|--grid|--move|--twist|--margin|\
    --translate|--rotate|--scale|--direction|--up) return ;;
  esac
  case $command in
    "") words=")" +
         commands + option_words(app) + R"(" ;;
)" + cases +
         R"(  esac
  if [[ $command == completion && $word != -* ]]; then
    COMPREPLY=($(compgen -W "bash zsh fish" -- "$word"))
  elif [[ $command == schema && $word != -* ]]; then
    COMPREPLY=($(compgen -W "assembly certificate" -- "$word"))
  elif [[ $command == manual && $word != -* ]]; then
    COMPREPLY=($(compgen -W ")" +
         commands + R"(" -- "$word"))
  elif [[ -z $command || $word == -* ]]; then
    COMPREPLY=($(compgen -W "$words" -- "$word"))
  else
    local IFS=$'\n'
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}
complete -o filenames -F _dupin dupin
)";
}

}  // namespace dupin::cli
