#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace dupin::cli {

/// An option of a command, as manuals and completions need it.
struct OptionInfo {
  std::vector<std::string> short_names, long_names;  ///< without dashes
  std::string positional;                            ///< "FILE"; empty for options
  std::string value;                                 ///< "LENGTH"; empty for flags and positionals
  std::vector<std::string> choices;                  ///< all that it takes, where that is a list
  std::string text;                                  ///< its help, as one line
  bool required = false, repeated = false;

  [[nodiscard]] bool is_flag() const { return positional.empty() && value.empty(); }
  [[nodiscard]] bool takes_file() const;
};

/// In the order of their help.
[[nodiscard]] std::vector<OptionInfo> options_of(const CLI::App& command);

/// All commands, in the order of the help.
[[nodiscard]] std::vector<const CLI::App*> commands_of(const CLI::App& app);

/// The text with every occurrence of one of `characters` after `mark`.
[[nodiscard]] std::string marked(const std::string& text, const std::string& characters,
                                 const std::string& mark);

}  // namespace dupin::cli
