#include "argument_checks.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/App.hpp>

#include "dupin/io/atomic_file.h"
#include "dupin/io/streamed_format.h"
#include "exchange_options.h"
#include "exit_code.h"
#include "interrupt.h"
#include "output.h"

namespace dupin::cli {
namespace {

namespace fs = std::filesystem;

struct NamedFile {
  std::string option;
  fs::path path, typed;
  bool lists_others = false;  ///< a .pvtu, with files NAME_0.vtu and so on beside it
};

bool is_flag(const CLI::Option& option) { return option.get_items_expected_max() == 0; }

std::string name_of(const CLI::Option& option) {
  return option.get_lnames().empty() ? option.get_name(true) : "--" + option.get_lnames().front();
}

void refuse_empty_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (!is_flag(*option) && std::ranges::any_of(option->results(), &std::string::empty)) {
      throw UsageError(name_of(*option) + " is empty: give it a value, or leave it out");
    }
  }
}

/// The mesh, certificate, page or document that the command is for.
bool is_main_output(const CLI::Option& option) {
  return option.check_lname("output") || (option.get_positional() && option.check_name("OUT"));
}

bool is_output(const CLI::Option& option) {
  return is_main_output(option) || option.check_lname("patches") || option.check_lname("report");
}

bool is_input(const CLI::Option& option) {
  return (option.get_positional() && !is_output(option)) || option.check_lname("certificate");
}

bool writes_new_versions(const CLI::App& command) {
  constexpr std::array kCommands{"union",  "intersect", "subtract", "boolean", "convert",
                                 "repair", "simplify",  "remesh",   "edit"};
  return std::ranges::find(kCommands, command.get_name()) != kCommands.end();
}

bool is_pvtu(const CLI::App& command, const fs::path& path) {
  const CLI::Option* const format = command.get_option_no_throw("--format");
  const bool is_said = format != nullptr && format->count() > 0;
  return is_said ? format->results().front() == kPvtu.key
                 : lower_extension(path.string()) == kPvtu.extension;
}

/// Those that are files, or may become one, of the options that are asked for.
template <class IsWanted>
std::vector<NamedFile> files_of(const CLI::App& command, const IsWanted& is_wanted) {
  std::vector<NamedFile> files;
  for (const CLI::Option* option : command.get_options()) {
    if (is_flag(*option) || !is_wanted(*option)) {
      continue;
    }
    const bool is_named = option->get_name(true).find('=') != std::string::npos;  // NAME=FILE
    for (const std::string& value : option->results()) {
      const std::size_t name_end = is_named ? value.find('=') : std::string::npos;
      const std::string typed = name_end == std::string::npos ? value : value.substr(name_end + 1);
      fs::path path = file_at(typed);
      if (!path.empty()) {
        const bool lists_others = is_main_output(*option) && is_pvtu(command, typed);
        files.push_back({name_of(*option), std::move(path), typed, lists_others});
      }
    }
  }
  return files;
}

/// Whether the path may be, or lead to, one of the files that are listed; how many there will be is
/// not known yet.
bool may_list(const NamedFile& file, const fs::path& path) {
  std::error_code failure;
  const fs::path folder = fs::absolute(file.typed, failure).parent_path();
  if (is_listed_name(path.filename().string(), file.typed) &&
      path.parent_path() == fs::weakly_canonical(folder, failure)) {
    return true;
  }
  return std::ranges::any_of(fs::directory_iterator(folder, failure), [&](const auto& entry) {
    return is_listed_name(entry.path().filename().string(), file.typed) &&
           file_at(entry.path().string()) == path;
  });
}

const NamedFile* find(const std::vector<NamedFile>& files, const fs::path& path) {
  const auto found = std::ranges::find_if(files, [&](const NamedFile& file) {
    return file.path == path || (file.lists_others && may_list(file, path));
  });
  return found != files.end() ? &*found : nullptr;
}

[[noreturn]] void refuse_in_place(const NamedFile& output, const fs::path& read) {
  throw UsageError(output.option + " would take the place of what is read: " + read.string());
}

void refuse_in_place_of(const std::vector<NamedFile>& inputs,
                        const std::vector<NamedFile>& outputs) {
  for (const NamedFile& file : inputs) {
    if (const NamedFile* const output = find(outputs, file.path)) {
      refuse_in_place(*output, file.path);
    }
  }
}

/// Of the command that is run, of which there is one in a process.
std::vector<NamedFile> the_outputs;

void refuse_shared_files(const CLI::App& command) {
  const std::vector<NamedFile> inputs = files_of(command, is_input);
  std::vector<NamedFile> outputs = files_of(command, is_main_output);
  if (!writes_new_versions(command)) {
    refuse_in_place_of(inputs, outputs);
  }
  const std::vector<NamedFile> beside =
      files_of(command, [](const CLI::Option& o) { return is_output(o) && !is_main_output(o); });
  refuse_in_place_of(inputs, beside);
  for (const NamedFile& file : beside) {
    if (const NamedFile* const other = find(outputs, file.path)) {
      throw UsageError(file.option + " takes a file of its own, not that of " + other->option +
                       ": " + file.path.string());
    }
    outputs.push_back(file);
  }
  the_outputs = std::move(outputs);
}

}  // namespace

void require_sound_arguments(const CLI::App& app, const CLI::App& command) {
  refuse_empty_values(app);
  refuse_empty_values(command);
  refuse_shared_files(command);
}

void require_writable_outputs() {
  for (const NamedFile& output : the_outputs) {
    writing([&] { (void)AsideFile(output.typed); });
    expect_file(output.typed.string());
  }
}

void require_not_written(const std::string& path) {
  const fs::path place = file_at(path);
  if (const NamedFile* const output = place.empty() ? nullptr : find(the_outputs, place)) {
    refuse_in_place(*output, place);
  }
}

fs::path file_at(const std::string& path) {
  std::error_code failure;
  fs::path place = fs::weakly_canonical(fs::absolute(end_of_links(path), failure), failure);
  const fs::file_type type = fs::status(place, failure).type();
  const bool is_file = type == fs::file_type::regular || type == fs::file_type::not_found ||
                       type == fs::file_type::directory;
  return is_file && output_path(path) != "-" ? place : fs::path();
}

bool are_one_file(const std::string& first, const std::string& second) {
  const fs::path place = file_at(first);
  return !place.empty() && place == file_at(second);
}

}  // namespace dupin::cli
