#include "option_list.h"

#include <algorithm>

#include <CLI/App.hpp>

namespace dupin::cli {
namespace {

std::string one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

/// "NAME:{off,stl}" is a name and what is allowed.
void read_type(const std::string& type, OptionInfo& info) {
  const std::size_t colon = type.find(':');
  info.value = type.substr(0, colon);
  const std::size_t open = type.find('{'), close = type.find('}');
  if (colon == std::string::npos || open == std::string::npos || close == std::string::npos) {
    return;
  }
  for (std::size_t begin = open + 1; begin < close;) {
    const std::size_t end = std::min(type.find(',', begin), close);
    info.choices.push_back(type.substr(begin, end - begin));
    begin = end + 1;
  }
}

}  // namespace

bool OptionInfo::takes_file() const {
  return choices.empty() && (value == "FILE" || value == "OUT" || value == "DIR");
}

std::vector<OptionInfo> options_of(const CLI::App& command) {
  std::vector<OptionInfo> infos;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) {  // hidden
      continue;
    }
    OptionInfo info{.short_names = option->get_snames(),
                    .long_names = option->get_lnames(),
                    .text = one_line(option->get_description()),
                    .required = option->get_required(),
                    .repeated = option->get_items_expected_max() > 1};
    if (option->get_positional()) {
      info.positional = option->get_name(true);
    }
    if (option->get_items_expected_max() > 0) {
      read_type(option->get_type_name(), info);
    }
    if (!info.positional.empty()) {
      info.value.clear();
    }
    infos.push_back(std::move(info));
  }
  return infos;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::string marked(const std::string& text, const std::string& characters,
                   const std::string& mark) {
  std::string result;
  for (const char character : text) {
    result += (characters.find(character) == std::string::npos ? "" : mark) + character;
  }
  return result;
}

}  // namespace dupin::cli
